/// A convex solid at its pose, from an ODE geom or a shape of a model.
#pragma once

#include "dynamics3d/ode.hpp"
#include "swarmanoid_space/state/entities.hpp"

namespace swarmanoid::dynamics3d {

/// Frame W.
struct PlacedSolid {
  /// @param geom a box, a cylinder or a sphere
  explicit PlacedSolid(dGeomID geom);
  PlacedSolid(const CollisionShape& shape, const Pose& body);

  /// The smallest box around it along W's axes.
  Eigen::AlignedBox3d bounds() const;

  CollisionShape::Kind kind = CollisionShape::Kind::kSphere;
  Eigen::Vector3d half = Eigen::Vector3d::Zero();  ///< as CollisionShape::half_extent [m]
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< its own axes, as columns
};

}  // namespace swarmanoid::dynamics3d
