/// When sensors with a rate of their own take samples: at the whole multiples of 1 / rate of simulated time.
#pragma once

#include <cmath>
#include <cstdint>

#include "swarmanoid_interface/time.hpp"

namespace swarmanoid::devices {

/// Returns the number of the last sample that was due by then. Times are whole nanoseconds, which are rounded in one
/// way only. @param rate samples in a second, above 0 [1/s]
inline std::int64_t samplesUntil(Time time, double rate) {
  constexpr double kAlmost = 1e-6;  // of a sample, for rounding
  return static_cast<std::int64_t>(std::floor(toSeconds(time) * rate + kAlmost));
}

}  // namespace swarmanoid::devices
