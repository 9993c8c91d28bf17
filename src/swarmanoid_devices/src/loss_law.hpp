/// By which law messages are lost: whatever the distance with one probability, and by the distance d with another one,
///
///     p = loss + (1 - loss) loss_at_range (d / range)^exponent
///
/// so a message comes if neither has lost it. Signals that fade randomly (Rayleigh) fall below what a receiver takes
/// with a probability that is, as long as it is small, proportional to the loss of power on the way: d^n, where n is 2
/// in free space, 3 to 5 in buildings (Rappaport, Wireless Communications, 2nd edition 2002, 4.9 and 5.6).
#pragma once

#include <cmath>
#include <cstdint>

#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid::devices {

class LossLaw {
 public:
  LossLaw() = default;
  /// Reads `loss`, `loss_at_range` and `loss_exponent`. @param range [m]
  LossLaw(const Configuration& parameters, double range)
      : loss_(parameters.number("loss", 0.0)),
        at_range_(parameters.number("loss_at_range", 0.0)),
        exponent_(parameters.integer("loss_exponent", std::int64_t{2})),
        squared_range_(range * range) {}

  /// Whether any message is ever lost.
  bool loses() const { return loss_ > 0.0 || at_range_ > 0.0; }

  /// @param squared_distance at most that of the range [m2]
  double probability(double squared_distance) const {
    if (at_range_ == 0.0) {
      return loss_;
    }
    // by products and a square root: the same bits everywhere
    const double squared_share = squared_distance / squared_range_;
    double power = exponent_ % 2 == 0 ? 1.0 : std::sqrt(squared_share);
    for (std::int64_t i = 1; i < exponent_; i += 2) {
      power *= squared_share;
    }
    return loss_ + (1.0 - loss_) * at_range_ * power;
  }

 private:
  double loss_ = 0.0;
  double at_range_ = 0.0;
  std::int64_t exponent_ = 2;
  double squared_range_ = 1.0;  // m2
};

}  // namespace swarmanoid::devices
