/// Overlaps of bodies: tests their shapes (figure 3.9) and their heights against each other. Threads: the functions may
/// run concurrently.
#pragma once

#include "planar/bodies.hpp"
#include "planar/planar_overlap.hpp"

namespace swarmanoid::planar {

/// Whether a model at a pose overlaps a body.
/// @param along coordinate of the model's origin along the plane's normal [m]
bool modelsOverlap(const PlanarModel& model, const PlacedPose& pose, double along, const Body& other);

/// The deepest overlap of any shape of the model with one of the body, and the shortest way out of it, in the plane's
/// frame. Parameters as above.
Penetration deepestPenetration(const PlanarModel& model, const PlacedPose& pose, double along, const Body& other);

/// The oldest body that an entity at a pose would overlap; kNoBody if there is none. @param ignored rows of bodies to
/// skip
BodyIndex findOverlap(const Bodies& bodies, const EntityModel& model, const Pose& pose, Span<const Row> ignored);

}  // namespace swarmanoid::planar
