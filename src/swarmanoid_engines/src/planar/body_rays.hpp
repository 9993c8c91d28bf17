/// Rays against the bodies of a plane, extruded to their heights. Rays do not hit mirrors of entities that another
/// engine moves: that engine reports those hits.
#pragma once

#include "planar/bodies.hpp"
#include "swarmanoid_space/rays/obstacles.hpp"
#include "swarmanoid_space/rays/ray.hpp"

namespace swarmanoid::planar {

/// Whether a ray of the bundle could hit a body. Thread-safe.
bool mayHit(const Bodies& bodies, const RayBundle& rays);

/// As RayTarget::findObstacles, for a horizontal plane. Thread-safe. @param engine owner of the bodies
void findObstacles(const Engine& engine, const Bodies& bodies, const RayBundle& rays, Obstacles& found);

/// As RayTarget::raycast. Thread-safe.
void raycast(const Bodies& bodies, const RayBundle& rays, Span<RayHit> hits);

/// As findObstacles, for one body. @param middle of the rays, in the plane's frame
void addObstacle(const Engine& engine, const Bodies& bodies, BodyIndex index, const RayBundle& rays,
                 const Eigen::Vector2d& middle, Obstacles& found);

/// As RayTarget::castRayAt. Thread-safe. The parts of a solid are the shapes of a body.
void castRayAt(const Bodies& bodies, const Obstacles::Solid& solid, const Segment& segment, RayHit& hit);

/// Whether the segment hits that body. Thread-safe.
bool isHit(const Bodies& bodies, const Segment& segment, BodyIndex index);

}  // namespace swarmanoid::planar
