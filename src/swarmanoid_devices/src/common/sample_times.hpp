/// Sample times of sensors with their own rate: whole multiples of 1 / rate in simulated time.
#pragma once

#include <cmath>
#include <cstdint>

#include "swarmanoid_interface/time.hpp"

namespace swarmanoid::devices {

/// Returns the number of the last sample that is due at `time`. Times are whole nanoseconds, so a tolerance absorbs
/// their rounding. @param rate samples per second, above 0 [1/s]
inline std::int64_t samplesUntil(Time time, double rate) {
  constexpr double kAlmost = 1e-6;  // tolerance for rounding, as a fraction of a sample
  return static_cast<std::int64_t>(std::floor(toSeconds(time) * rate + kAlmost));
}

}  // namespace swarmanoid::devices
