/// From a model's shapes to ODE's geoms.
///
/// A robot with wheels stands on balls (balls.hpp) alone: shapes that reach down to the ground (outlines of treels,
/// casters) end a little above it.
#pragma once

#include <vector>

#include "dynamics3d/body.hpp"

namespace swarmanoid::dynamics3d {

/// The geom of one shape, grown on all sides. @param growth [m]
dGeomID makeGeom(const CollisionShape& shape, double growth);

/// Makes a body's solids, each grown by half of kMargin, in B; `rigid` carries them if there is one.
void addSolids(Body& body);

/// The shapes with which an entity stands on the ground when this engine moves it: of a driven robot those that end
/// above the ground, and its balls.
std::vector<CollisionShape> shapesOnGround(const EntityModel& model);

}  // namespace swarmanoid::dynamics3d
