/// Geometry of a picture: triangles, balls and rods, each of one colour. World frame, metres.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

namespace swarmanoid {

/// Red, green, blue and opacity, from 0 to 1.
using Tint = Eigen::Vector4f;

struct Geometry {
  std::vector<Eigen::Vector3f> corners;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices into corners
  std::vector<Tint> triangle_tints;                     ///< one per triangle

  std::vector<Eigen::Vector4f> balls;  ///< centre and radius
  std::vector<Tint> ball_tints;

  std::vector<Eigen::Vector4f> rods;  ///< two per rod: its ends, each with the radius
  std::vector<Tint> rod_tints;        ///< one per rod

  void addTriangle(const std::array<Eigen::Vector3d, 3>& at, const Tint& tint);
  void addBall(const Eigen::Vector3d& middle, double radius, const Tint& tint);
  void addRod(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius, const Tint& tint);
  /// @param pose of its centre @param size along its axes
  void addBox(const Eigen::Isometry3d& pose, const Eigen::Vector3d& size, const Tint& tint);
  /// A cylinder along the z axis of its pose; may be elliptic.
  void addCylinder(const Eigen::Isometry3d& pose, const Eigen::Vector3d& size, const Tint& tint);
  /// An ellipsoid with diameters `size` along its axes. A sphere is exact, other ellipsoids are triangles.
  void addEllipsoid(const Eigen::Isometry3d& pose, const Eigen::Vector3d& size, const Tint& tint);
};

}  // namespace swarmanoid
