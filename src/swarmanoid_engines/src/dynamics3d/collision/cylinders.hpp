/// Contacts of cylinders where ODE finds a single point, although more are needed to hold a body: it would rock from
/// one point to the next and sink in. Where ODE finds several, it treats a cylinder as a prism of eight sides, which
/// topples too early. No contact depends on the axes of W.
#pragma once

#include "dynamics3d/ode.hpp"

namespace swarmanoid::dynamics3d {

/// Cylinders that stand side by side, such as robots: two contacts, at both ends of the height where the sides face
/// each other.
/// @param found array of two
/// @return number of contacts; 0 if the geoms are not both cylinders, stand at an angle, or do not touch with their
/// sides
int collideSides(dGeomID a, dGeomID b, dContactGeom* found);

/// A cylinder on a plane: up to four contacts around a face, two along its side, or one on an edge.
/// @param found array of four
/// @return number of contacts; 0 if the first geom is not a cylinder
int collidePlane(dGeomID cylinder, dGeomID plane, dContactGeom* found);

/// A cylinder that stands on a face of a box, or carries one: the corners of the common area of their faces, at most
/// four that are spread.
/// @param found array of four
/// @return number of contacts; 0 if the geoms are not a box and a cylinder, or touch with their sides
int collideFaces(dGeomID a, dGeomID b, dContactGeom* found);

}  // namespace swarmanoid::dynamics3d
