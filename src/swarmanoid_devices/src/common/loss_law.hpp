/// Loss probability of messages: a constant one, combined with one that grows with the distance d,
///
///     p = loss + (1 - loss) loss_at_range (d / range)^exponent
///
/// so a message arrives if neither loses it. Randomly fading signals (Rayleigh) fall below the threshold of a receiver
/// with a probability that is, while small, proportional to the path loss: d^n, where n is 2 in free space, and 3 to 5
/// in buildings (Rappaport, Wireless Communications, 2nd edition 2002, 4.9 and 5.6).
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

  /// Whether any message can be lost.
  bool loses() const { return loss_ > 0.0 || at_range_ > 0.0; }

  /// @param squared_distance at most the squared range [m2]
  double probability(double squared_distance) const {
    if (at_range_ == 0.0) {
      return loss_;
    }
    // products and a square root give the same bits on all platforms
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
