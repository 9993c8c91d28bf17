/// Footprints of bodies on the ground, with their height ranges, to detect contacts independently of the engines.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

/// A rectangle with a margin around it, seen from above, in W. A disc is a point with a margin.
struct Footprint {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  // m
  Eigen::Vector2d along = Eigen::Vector2d::UnitX();  // direction of the first side, of length 1
  Eigen::Vector2d half = Eigen::Vector2d::Zero();    // half lengths of the sides [m]
  double margin = 0.0;                               // m
  double low = 0.0;                                  // m
  double high = 0.0;                                 // m
};

/// Spheres, and cylinders up to 30 degrees from upright, are discs. Other shapes are replaced by their upright bounding
/// box with the same heading.
inline Footprint footprintOf(const CollisionShape& shape, const Pose& pose) {
  const Eigen::Vector3d centre = pose.toWorld(shape.position);
  const Eigen::Matrix3d turn = (pose.orientation * shape.orientation).toRotationMatrix();
  constexpr double kUpright = 0.866;
  const bool is_sphere = shape.kind == CollisionShape::Kind::kSphere;
  Footprint print;
  print.centre = centre.head<2>();
  double half_height = shape.half_extent.z();
  if (is_sphere || (shape.kind == CollisionShape::Kind::kCylinder && std::abs(turn(2, 2)) >= kUpright)) {
    print.margin = shape.half_extent.x();
    half_height = is_sphere ? shape.half_extent.x() : half_height;
  } else {
    const int axis = turn.row(2).head<2>().cwiseAbs().x() < 0.9 ? 0 : 1;  // an axis that is not vertical
    print.along = turn.col(axis).head<2>().normalized();
    const Eigen::Vector2d across(-print.along.y(), print.along.x());
    print.half.x() = (print.along.transpose() * turn.topRows<2>()).cwiseAbs() * shape.half_extent;
    print.half.y() = (across.transpose() * turn.topRows<2>()).cwiseAbs() * shape.half_extent;
    half_height = turn.row(2).cwiseAbs() * shape.half_extent;
  }
  print.low = centre.z() - half_height;
  print.high = centre.z() + half_height;
  return print;
}

/// Footprints of all shapes of an entity, at the current angles of its joints. @param prints is cleared first
inline void footprintsOf(const Space& space, Row row, std::vector<Footprint>& prints) {
  const EntityModel& model = *space.entities.model[row];
  prints.clear();
  for (const CollisionShape& shape : model.shapes) {
    const bool is_turned = shape.joint >= 0;
    prints.push_back(
        footprintOf(is_turned ? placeOf(model, space.joints[row], shape) : shape, space.entities.pose[row]));
  }
}

/// Distance from a point to the rectangle without margin; 0 inside it [m].
inline double distanceFrom(const Eigen::Vector2d& point, const Footprint& rectangle) {
  const Eigen::Vector2d off = point - rectangle.centre;
  const Eigen::Vector2d across(-rectangle.along.y(), rectangle.along.x());
  const Eigen::Vector2d in_frame(std::abs(off.dot(rectangle.along)), std::abs(off.dot(across)));
  return (in_frame - rectangle.half).cwiseMax(0.0).norm();
}

/// Least distance of the corners of one rectangle from the other rectangle [m].
inline double distanceOfCorners(const Footprint& one, const Footprint& other) {
  const Eigen::Vector2d along = one.half.x() * one.along;
  const Eigen::Vector2d across = one.half.y() * Eigen::Vector2d(-one.along.y(), one.along.x());
  double least = distanceFrom(one.centre + along + across, other);
  least = std::min(least, distanceFrom(one.centre + along - across, other));
  least = std::min(least, distanceFrom(one.centre - along + across, other));
  return std::min(least, distanceFrom(one.centre - along - across, other));
}

/// Whether a side of `one` separates the rectangles. They overlap if no side of either does.
inline bool isSeparatedBySideOf(const Footprint& one, const Footprint& other) {
  const Eigen::Vector2d off = other.centre - one.centre;
  for (int side = 0; side < 2; ++side) {
    const Eigen::Vector2d normal = side == 0 ? one.along : Eigen::Vector2d(-one.along.y(), one.along.x());
    const Eigen::Vector2d across(-other.along.y(), other.along.x());
    const double reach = one.half[side] + other.half.x() * std::abs(normal.dot(other.along)) +
                         other.half.y() * std::abs(normal.dot(across));
    if (std::abs(normal.dot(off)) > reach) {
      return true;
    }
  }
  return false;
}

/// Horizontal gap between two footprints; 0 or less if they overlap [m].
inline double gapBetween(const Footprint& one, const Footprint& other) {
  double between = 0.0;
  if (isSeparatedBySideOf(one, other) || isSeparatedBySideOf(other, one)) {
    between = std::min(distanceOfCorners(one, other), distanceOfCorners(other, one));
  }
  return between - one.margin - other.margin;
}

/// Whether two bodies touch sideways, at a common height. A body does not touch its support.
inline bool areTouching(const Footprint& one, const Footprint& other, double gap) {
  constexpr double kOnTop = 0.001;  // m, penetration of a body into its support
  return std::min(one.high, other.high) - std::max(one.low, other.low) > kOnTop && gapBetween(one, other) <= gap;
}

}  // namespace swarmanoid::devices
