/// Counter-based random numbers (Philox, Salmon et al. 2011, from the Random123 library).
///
/// A number is a pure function of (seed, stream name, tick, draw). It does not depend on the order in which robots are
/// updated, on threads, on processes or on subscribers, and a stream needs no state beyond its draw count.
#pragma once

#include <cstdint>
#include <string_view>

#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid {

/// FNV-1a of a text: unlike std::hash it is the same on every machine and in every process.
std::uint64_t stableHash(std::string_view text);

class RandomStream {
 public:
  RandomStream() = default;
  /// @param stream identifies the stream: stableHash of the entity's name combined with the device's
  RandomStream(std::uint64_t seed, std::uint64_t stream) : seed_(seed), stream_(stream) {}
  RandomStream(std::uint64_t seed, std::string_view entity, std::string_view device);

  /// Starts the sequence of the tick; it does not depend on the draws of other ticks.
  void startTick(std::uint64_t tick) {
    tick_ = tick;
    draw_ = 0;
  }

  /// Sets another seed for the ticks that start from now on.
  void reseed(std::uint64_t seed) { seed_ = seed; }

  /// Returns 64 random bits.
  std::uint64_t bits();
  /// Returns a number uniform in [0, 1).
  double uniform();
  /// Returns a number uniform in [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Returns a number uniform among 0 .. count - 1. @pre count > 0
  std::uint64_t below(std::uint64_t count) {
    SWARMANOID_EXPECTS(count > 0);
    return bits() % count;
  }
  /// Returns a normal number with the given mean and standard deviation (Box-Muller).
  double gaussian(double mean = 0.0, double standard_deviation = 1.0);

 private:
  std::uint64_t seed_ = 0;
  std::uint64_t stream_ = 0;
  std::uint64_t tick_ = 0;
  std::uint32_t draw_ = 0;
};

}  // namespace swarmanoid
