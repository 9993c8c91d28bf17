/// From a model's shapes to ODE's geoms.
///
/// A robot with wheels stands on balls, three for each treel: the wheel in the middle, and one before and one behind it
/// that keep it from tipping. Balls touch whatever ground in a point under the wheel's axle, so a robot turns as its
/// wheels' separation says, which flat wheels do not. The balls lie within the shapes as seen from above. Shapes that
/// reach down to the ground (the treels' outlines) end a little above it, so that the balls alone carry the robot.
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
