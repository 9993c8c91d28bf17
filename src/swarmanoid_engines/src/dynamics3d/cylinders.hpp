/// Contacts between cylinders that stand side by side, such as robots: ODE finds one point only, at an end of one of
/// them, so that they would turn each other over.
#pragma once

#include "dynamics3d/ode.hpp"

namespace swarmanoid::dynamics3d {

/// Two contacts, where the sides begin and cease to face each other. @param found room for two
/// @return their number; 0 if the geoms are not both cylinders, stand at an angle, or do not touch with their sides
int collideSides(dGeomID a, dGeomID b, dContactGeom* found);

}  // namespace swarmanoid::dynamics3d
