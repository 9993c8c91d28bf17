/// Rays of distance sensors: they hit solids, the terrain and the level floor, which no engine includes in its rays.
///
/// Threads: const functions, safe from any number of threads.
#pragma once

#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

/// Whether a ray of the bundle could hit anything; true if uncertain. The segments of the bundle are not used.
/// @param lowest lowest height that the rays reach, in W [m]
inline bool mayMeasure(const Space& space, const RayBundle& rays, double lowest) {
  return lowest <= 0.0 || space.mayHit(rays);
}

/// Refuses an empty measuring range. @param parameters of the sensor, with range_min and range_max
/// @throws ConfigError
void refuseEmptyRange(const Range& range, const Configuration& parameters);

/// As Space::raycast, but the level floor also stops rays: z = 0, where there is neither terrain nor a hole.
void castDistances(const Space& space, const RayBundle& rays, Span<RayHit> hits);

// Readings of a target that is too close, selected by the parameter `too_close`.
constexpr const char* kReported = "reported";  ///< minus infinity
constexpr const char* kFolded = "folded";      ///< Distance::foldedReading
Parameter tooCloseParameter();

}  // namespace swarmanoid::devices
