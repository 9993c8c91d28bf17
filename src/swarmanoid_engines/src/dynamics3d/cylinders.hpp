/// Contacts of cylinders where ODE finds one point only, though it takes more of them to hold a body: it would rock
/// from one point to the next and sink in. Where ODE finds several, it takes a cylinder for a prism of eight sides,
/// which topples too early. None of them depends on the axes of W.
#pragma once

#include "dynamics3d/ode.hpp"

namespace swarmanoid::dynamics3d {

/// Cylinders that stand side by side, such as robots: two contacts, where the sides begin and cease to face each other.
/// @param found room for two
/// @return their number; 0 if the geoms are not both cylinders, stand at an angle, or do not touch with their sides
int collideSides(dGeomID a, dGeomID b, dContactGeom* found);

/// A cylinder on a plane: on a face four contacts around it, on its side two, on an edge one of them.
/// @param found room for four
/// @return their number; 0 if the first geom is no cylinder
int collidePlane(dGeomID cylinder, dGeomID plane, dContactGeom* found);

/// A cylinder that stands on a face of a box, or bears one: the corners of what their faces have in common, at most
/// four that are spread.
/// @param found room for four
/// @return their number; 0 if the geoms are not a box and a cylinder, or touch with their sides
int collideFaces(dGeomID a, dGeomID b, dContactGeom* found);

}  // namespace swarmanoid::dynamics3d
