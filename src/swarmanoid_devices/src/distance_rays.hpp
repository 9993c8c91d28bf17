/// Rays of distance sensors: what they hit, be it a solid, the terrain or the level floor, which no engine answers for.
///
/// Threads: const from any number of them.
#pragma once

#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

/// Whether a ray of the bundle could hit anything; in doubt, yes. Its segments are not looked at.
/// @param lowest height in W to which the rays go down [m]
inline bool mayMeasure(const Space& space, const RayBundle& rays, double lowest) {
  return lowest <= 0.0 || space.mayHit(rays);
}

/// Refuses a range in which nothing can be measured. @param parameters of the sensor, with range_min and range_max
/// @throws ConfigError
void refuseEmptyRange(const Range& range, const Configuration& parameters);

/// As Space::raycast, and the level floor stops rays, too: z = 0, where there is neither terrain nor a hole.
void castDistances(const Space& space, const RayBundle& rays, Span<RayHit> hits);

// What a sensor says of something that is too close, as the parameter `too_close` chooses.
constexpr const char* kReported = "reported";  ///< that it is: minus infinity
constexpr const char* kFolded = "folded";      ///< Distance::foldedReading
Parameter tooCloseParameter();

}  // namespace swarmanoid::devices
