/// Contacts of two boxes.
///
/// ODE 0.16.2 finds none in one of seven poses that are turned by 90 degrees, and in some others; boxes on tilted boxes
/// fell through. So contacts are found here: the axis along which the boxes are farthest apart, or least deep in each
/// other, out of the six normals of faces and the nine directions across two edges (separating axis theorem;
/// Gottschalk, Lin, Manocha 1996). Where a face has that axis, the face of the other box that looks at it is clipped to
/// it. Where two edges have it, the contact is where they are nearest to each other. No box nearer than the margin is
/// missed, since each axis leaves at least one contact.
#pragma once

#include "dynamics3d/placed_solid.hpp"
#include "dynamics3d/surface_contacts.hpp"

namespace swarmanoid::dynamics3d {

constexpr int kMostBoxContacts = 4;

/// Contacts of two boxes of the sizes that they have in the model: normals out of `b`, depths below 0 where surfaces
/// are apart. The first one is the deepest, or where all are as deep, lies farthest downhill; the others are spread.
/// @param margin boxes that are farther apart have no contact [m] @param found room for kMostBoxContacts
/// @return their number. Where surfaces are nearer than `margin`, it is at least 1
int collideBoxes(const PlacedSolid& a, const PlacedSolid& b, double margin, SurfaceContact* found);

/// The same for geoms that are enlarged by half the margin on each side (kMargin), with depths as ODE would give them.
/// @return their number; 0 also if the geoms are not both boxes
int collideBoxes(dGeomID a, dGeomID b, dContactGeom* found);

}  // namespace swarmanoid::dynamics3d
