/// Counter-based random numbers (Philox, Salmon et al. 2011, from the Random123 library).
///
/// A number is a pure function of (seed, stream name, tick, draw). It does not depend on the order in which robots are
/// updated, on threads, on processes or on who is subscribed, and a stream needs no state beyond its draw count.
#pragma once

#include <cstdint>
#include <string_view>

#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid {

/// FNV-1a of a text: the same on every machine and in every process, unlike std::hash.
std::uint64_t stableHash(std::string_view text);

class RandomStream {
 public:
  RandomStream() = default;
  /// @param stream who draws: stableHash of the entity's name combined with the device's
  RandomStream(std::uint64_t seed, std::uint64_t stream) : seed_(seed), stream_(stream) {}
  RandomStream(std::uint64_t seed, std::string_view entity, std::string_view device);

  /// Starts the tick's own sequence; draws of other ticks do not matter.
  void startTick(std::uint64_t tick) {
    tick_ = tick;
    draw_ = 0;
  }

  /// 64 random bits.
  std::uint64_t bits();
  /// Uniform in [0, 1).
  double uniform();
  /// Uniform in [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Uniform among 0 .. count - 1. @pre count > 0
  std::uint64_t below(std::uint64_t count) {
    SWARMANOID_EXPECTS(count > 0);
    return bits() % count;
  }
  /// Normal with the given mean and standard deviation (Box-Muller).
  double gaussian(double mean, double standard_deviation);

 private:
  std::uint64_t seed_ = 0;
  std::uint64_t stream_ = 0;
  std::uint64_t tick_ = 0;
  std::uint32_t draw_ = 0;
};

}  // namespace swarmanoid
