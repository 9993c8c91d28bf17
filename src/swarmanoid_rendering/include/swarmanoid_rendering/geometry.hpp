/// What a picture shows: triangles, balls and rods, each of one colour. World frame, metres.
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
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< of corners
  std::vector<Tint> triangle_tints;                     ///< one a triangle

  std::vector<Eigen::Vector4f> balls;  ///< middle and radius
  std::vector<Tint> ball_tints;

  std::vector<Eigen::Vector4f> rods;  ///< two a rod: its ends, each with the radius
  std::vector<Tint> rod_tints;        ///< one a rod

  void addTriangle(const std::array<Eigen::Vector3d, 3>& at, const Tint& tint);
  void addBall(const Eigen::Vector3d& middle, double radius, const Tint& tint);
  void addRod(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius, const Tint& tint);
  /// @param pose of its middle @param size along its axes
  void addBox(const Eigen::Isometry3d& pose, const Eigen::Vector3d& size, const Tint& tint);
  /// Upright in its pose; may be elliptic.
  void addCylinder(const Eigen::Isometry3d& pose, const Eigen::Vector3d& size, const Tint& tint);
  /// A ball of `size` along its axes; one that is round is exact.
  void addEllipsoid(const Eigen::Isometry3d& pose, const Eigen::Vector3d& size, const Tint& tint);
};

}  // namespace swarmanoid
