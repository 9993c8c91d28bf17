/// Rays against the bodies of a plane, extruded to their heights. A mirror of what another engine moves is not met:
/// that engine answers for it.
#pragma once

#include "planar/bodies.hpp"
#include "swarmanoid_space/rays/ray.hpp"

namespace swarmanoid::planar {

/// Whether a ray of the bundle could meet a body. Thread-safe.
bool mayMeet(const Bodies& bodies, const RayBundle& rays);

/// As Engine::castRays. Thread-safe.
void castRays(const Bodies& bodies, const RayBundle& rays, Span<RayHit> hits);

}  // namespace swarmanoid::planar
