/// Contact points of two shapes that touch, or may touch within a step.
///
/// Box2D finds which corners and sides face each other, from the relative pose of the shapes; their positions are
/// computed here, in double precision. So contacts do not depend on the position in the world, nor on its axes.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "dynamics2d/contact_shape.hpp"
#include "planar/placed_pose.hpp"

namespace swarmanoid::dynamics2d {

/// Gaps below it are contacts, however slow the bodies are [m].
constexpr double kContactMargin = 1e-3;

/// Two points that face each other, in the frames of their bodies' centres of mass.
struct FacingPoints {
  Eigen::Vector2d on_a = Eigen::Vector2d::Zero();
  Eigen::Vector2d on_b = Eigen::Vector2d::Zero();
  std::uint32_t key = 0;  ///< identifies the features: equal in the next step if the same ones still face each other
};

struct ContactPatch {
  /// The normal as bodies move: that of a polygon's side, or the line between the two points.
  enum class Kind : std::uint8_t { kPoints, kSideOfA, kSideOfB };

  Kind kind = Kind::kPoints;
  int count = 0;                                   ///< of points; 0: the shapes are farther apart than the margin
  Eigen::Vector2d side = Eigen::Vector2d::Zero();  ///< normal of that side, out of its body, in its frame
  double radius_a = 0.0;                           ///< from `on_a` to the surface; 0 except for circles [m]
  double radius_b = 0.0;                           ///< from `on_b` to the surface [m]
  std::array<FacingPoints, 2> points;
};

/// A pair of facing points at the current poses of their bodies.
struct Facing {
  Eigen::Vector2d normal;  ///< from a to b
  Eigen::Vector2d arm_a;   ///< from the centre of mass to the surface, in the plane's axes [m]
  Eigen::Vector2d arm_b;   ///< as arm_a, for b [m]
  double gap;              ///< below 0: depth of penetration [m]
};

/// @param a, b poses of the centres of mass; @param margin largest gap of contacts [m]
ContactPatch findPatch(const ContactShape& shape_a, const planar::PlacedPose& a, const ContactShape& shape_b,
                       const planar::PlacedPose& b, double margin);

/// @param point its index in the patch
inline Facing facingAt(const ContactPatch& patch, int point, const planar::PlacedPose& a, const planar::PlacedPose& b) {
  constexpr double kSame = 1e-9;  // m
  const FacingPoints& points = patch.points[static_cast<std::size_t>(point)];
  Facing facing;
  facing.arm_a = a.rotated(points.on_a);
  facing.arm_b = b.rotated(points.on_b);
  const Eigen::Vector2d between = b.position - a.position + facing.arm_b - facing.arm_a;
  double distance = 0.0;
  if (patch.kind == ContactPatch::Kind::kPoints) {
    distance = between.norm();
    facing.normal = distance > kSame ? Eigen::Vector2d(between / distance) : a.rotated(Eigen::Vector2d::UnitX());
  } else {
    facing.normal =
        patch.kind == ContactPatch::Kind::kSideOfA ? a.rotated(patch.side) : Eigen::Vector2d(-b.rotated(patch.side));
    distance = facing.normal.dot(between);
  }
  facing.gap = distance - patch.radius_a - patch.radius_b;
  facing.arm_a += patch.radius_a * facing.normal;
  facing.arm_b -= patch.radius_b * facing.normal;
  return facing;
}

}  // namespace swarmanoid::dynamics2d
