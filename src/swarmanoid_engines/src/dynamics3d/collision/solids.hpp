/// Makes ODE's geoms from a model's shapes.
///
/// A robot with wheels stands only on balls (balls.hpp): shapes that reach down to the ground (outlines of treels,
/// casters) end a little above it.
#pragma once

#include <vector>

#include "dynamics3d/body.hpp"

namespace swarmanoid::dynamics3d {

/// The geom of one shape, grown on all sides. @param growth [m]
dGeomID makeGeom(const CollisionShape& shape, double growth);

/// Makes a body's solids, each grown by half of kMargin, in B; `rigid` carries them if there is one.
void addSolids(Body& body);

/// Shapes on which an entity stands when this engine moves it: for driven robots, the shapes that end above the ground,
/// and the balls.
std::vector<CollisionShape> shapesOnGround(const EntityModel& model);

}  // namespace swarmanoid::dynamics3d
