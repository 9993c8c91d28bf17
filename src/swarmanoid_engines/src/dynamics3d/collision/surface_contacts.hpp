/// Candidate contacts of a solid with a surface, of which the best few become contacts. Frame W.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "dynamics3d/ode.hpp"

namespace swarmanoid::dynamics3d {

/// A point where a solid touches a surface, or nearly does.
struct SurfaceContact {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< out of the surface
  double depth = 0.0;                                 ///< by which the solid is nearer than the margin [m]
};

/// Converts to ODE's format. @param solid the one that touches @param surface null: ground that is not ODE's
dContactGeom geometryOf(const SurfaceContact& contact, dGeomID solid, dGeomID surface);

/// Candidate contacts of one solid, without duplicates. When full, the shallowest are dropped.
class SurfaceContacts {
 public:
  void add(const SurfaceContact& contact);
  std::size_t size() const { return count_; }
  const SurfaceContact& operator[](std::size_t i) const { return contacts_[i]; }
  const SurfaceContact* begin() const { return contacts_.data(); }
  const SurfaceContact* end() const { return contacts_.data() + count_; }
  /// Keeps the deepest contact, and of the others those farthest from each other.
  void keepSpread(std::size_t most);

 private:
  static constexpr std::size_t kRoom = 48;
  std::array<SurfaceContact, kRoom> contacts_;
  std::size_t count_ = 0;
};

}  // namespace swarmanoid::dynamics3d
