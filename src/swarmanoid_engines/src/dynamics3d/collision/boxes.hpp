/// Contacts of two boxes.
///
/// ODE 0.16.2 finds none in one of seven poses that are turned by 90 degrees, and in some others; boxes on tilted boxes
/// fell through. So contacts are found here by the separating axis theorem (Gottschalk, Lin, Manocha 1996): among the
/// six face normals and the nine cross products of two edges, the axis with the widest gap, or the least depth. If the
/// axis is that of a face, the opposite face of the other box is clipped to it. If it is that of two edges, the contact
/// is where they are nearest to each other. No box nearer than the margin is missed, since each axis leaves at least
/// one contact.
#pragma once

#include "dynamics3d/collision/placed_solid.hpp"
#include "dynamics3d/collision/surface_contacts.hpp"

namespace swarmanoid::dynamics3d {

constexpr int kMostBoxContacts = 4;

/// Contacts of two boxes at their sizes in the model: normals out of `b`, depths below 0 for gaps. The first contact is
/// the deepest, or, where all are equally deep, the one farthest downhill; the others are spread.
/// @param margin boxes that are farther apart have no contact [m] @param found array of kMostBoxContacts
/// @return number of contacts; at least 1 if surfaces are nearer than `margin`
int collideBoxes(const PlacedSolid& a, const PlacedSolid& b, double margin, SurfaceContact* found);

/// As above, for geoms that are enlarged by half the margin on each side (kMargin), with depths as from ODE.
/// @return number of contacts; 0 also if the geoms are not both boxes
int collideBoxes(dGeomID a, dGeomID b, dContactGeom* found);

}  // namespace swarmanoid::dynamics3d
