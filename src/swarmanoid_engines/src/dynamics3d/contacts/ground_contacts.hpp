/// Contacts of a solid with ground that is not level.
///
/// ODE has heightfields of its own, but finds no contact where a ball or a face meets a ridge: a footbot's treels would
/// fall through. So contacts are found here: balls touch the nearest points of the surface; boxes and cylinders touch
/// it with their corners and rims, and ridges and summits touch their faces.
#pragma once

#include <vector>

#include "dynamics3d/collision/ground_surface.hpp"
#include "dynamics3d/collision/placed_solid.hpp"
#include "dynamics3d/collision/surface_contacts.hpp"

namespace swarmanoid::dynamics3d {

/// All contacts of a solid that is nearer to the ground than `margin` [m]. Allocates nothing.
/// @pre ground.isRoughAt(solid's bounds)
SurfaceContacts collideGround(const GroundSurface& ground, const PlacedSolid& solid, double margin);

/// Height by which shapes must be lifted until none of them is in the ground [m]; 0 if none is.
/// @pre ground.isRoughAt(entity's bounds)
double riseOut(const GroundSurface& ground, const std::vector<CollisionShape>& shapes, const Pose& body);

// The parts of collideGround.

/// Contact of a point of a solid. Near a cliff, a point in the ground leaves it by the shorter way.
/// @param radius of a ball around the point
void collidePoint(const GroundSurface& ground, const Eigen::Vector3d& point, double radius, double margin,
                  SurfaceContacts& contacts);
void collideBall(const GroundSurface& ground, const PlacedSolid& ball, double margin, SurfaceContacts& contacts);
void collideCorners(const GroundSurface& ground, const PlacedSolid& box, double margin, SurfaceContacts& contacts);
void collideRims(const GroundSurface& ground, const PlacedSolid& cylinder, double margin, SurfaceContacts& contacts);
/// @param solid a box or a cylinder
void collideRidges(const GroundSurface& ground, const PlacedSolid& solid, double margin, SurfaceContacts& contacts);

}  // namespace swarmanoid::dynamics3d
