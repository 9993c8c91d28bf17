/// Rays against the bodies of a plane, extruded to their heights. A mirror of what another engine moves is not hit:
/// that engine answers for it.
#pragma once

#include "planar/bodies.hpp"
#include "swarmanoid_space/rays/ray.hpp"

namespace swarmanoid::planar {

/// Whether a ray of the bundle could hit a body. Thread-safe.
bool mayHit(const Bodies& bodies, const RayBundle& rays);

/// As Engine::raycast. Thread-safe.
void raycast(const Bodies& bodies, const RayBundle& rays, Span<RayHit> hits);

/// Whether the segment hits that body. Thread-safe.
bool isHit(const Bodies& bodies, const Segment& segment, BodyIndex index);

}  // namespace swarmanoid::planar
