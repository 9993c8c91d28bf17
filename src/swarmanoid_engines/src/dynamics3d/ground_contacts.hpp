/// Contacts of a solid with ground that is not level.
///
/// ODE has heightfields of its own, but sees no contact where a ball or a face meets a ridge: a footbot's treels would
/// fall through. So contacts are found here. Balls meet the nearest points of the surface. Boxes and cylinders meet it
/// with their corners and rims, and ridges and summits meet their faces.
#pragma once

#include <array>
#include <vector>

#include "dynamics3d/ground_surface.hpp"
#include "dynamics3d/placed_solid.hpp"

namespace swarmanoid::dynamics3d {

/// Where a solid touches the ground, or nearly does.
struct GroundContact {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< out of the ground
  double depth = 0.0;                                 ///< by which the solid is nearer than the margin [m]
};

/// Those of one solid, each place once. Where there is no more room, the shallowest are left out.
class GroundContacts {
 public:
  void add(const GroundContact& contact);
  std::size_t size() const { return count_; }
  const GroundContact& operator[](std::size_t i) const { return contacts_[i]; }
  const GroundContact* begin() const { return contacts_.data(); }
  const GroundContact* end() const { return contacts_.data() + count_; }
  /// Keeps the deepest one, and of the others those that are farthest from each other.
  void keepSpread(std::size_t most);

 private:
  static constexpr std::size_t kRoom = 48;
  std::array<GroundContact, kRoom> contacts_;
  std::size_t count_ = 0;
};

/// All contacts of a solid that is nearer to the ground than `margin` [m]. Allocates nothing.
/// @pre ground.isRoughAt(solid's bounds)
GroundContacts meetGround(const GroundSurface& ground, const PlacedSolid& solid, double margin);

/// By how much shapes must be lifted until none of them is in the ground [m]; 0 if none is.
/// @pre ground.isRoughAt(entity's bounds)
double riseOut(const GroundSurface& ground, const std::vector<CollisionShape>& shapes, const Pose& body);

// The parts of meetGround.

/// A point of a solid: out of the ground it is in, on the shorter way, if it is by a cliff.
/// @param radius of a ball around the point
void meetPoint(const GroundSurface& ground, const Eigen::Vector3d& point, double radius, double margin,
               GroundContacts& contacts);
void meetBall(const GroundSurface& ground, const PlacedSolid& ball, double margin, GroundContacts& contacts);
void meetCorners(const GroundSurface& ground, const PlacedSolid& box, double margin, GroundContacts& contacts);
void meetRims(const GroundSurface& ground, const PlacedSolid& cylinder, double margin, GroundContacts& contacts);
/// @param solid a box or a cylinder
void meetRidges(const GroundSurface& ground, const PlacedSolid& solid, double margin, GroundContacts& contacts);

}  // namespace swarmanoid::dynamics3d
