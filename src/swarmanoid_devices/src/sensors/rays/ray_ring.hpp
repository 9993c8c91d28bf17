/// A ring of sensors with one ray each, all of the same length, and a fast search for the rays near an obstacle.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "ring_geometry.hpp"
#include "swarmanoid_space/rays/flat_rays.hpp"
#include "swarmanoid_space/rays/obstacles.hpp"
#include "swarmanoid_space/rays/ray.hpp"

namespace swarmanoid::devices {

/// Pose of an upright robot, with the rotation about z only. It transforms vectors as the rotation matrix of the pose
/// does, bit for bit.
class UprightPose {
 public:
  /// @pre pose.isUpright()
  explicit UprightPose(const Pose& pose)
      : position_(pose.position),
        cosine_(1.0 - 2.0 * pose.orientation.z() * pose.orientation.z()),
        sine_(2.0 * pose.orientation.w() * pose.orientation.z()) {}

  Eigen::Vector2d place() const { return position_.head<2>(); }
  Eigen::Vector2d toRobot(const Eigen::Vector2d& point) const {
    const double x = point.x() - position_.x();
    const double y = point.y() - position_.y();
    return {cosine_ * x + sine_ * y, cosine_ * y - sine_ * x};
  }
  Eigen::Vector3d toWorld(const Eigen::Vector3d& point) const {
    return {cosine_ * point.x() - sine_ * point.y() + position_.x(),
            sine_ * point.x() + cosine_ * point.y() + position_.y(), point.z() + position_.z()};
  }
  /// @param from in the robot's frame @param direction in the robot's frame @param range of the ray [m]
  Segment ray(const Eigen::Vector3d& from, const Eigen::Vector3d& direction, double range) const {
    const double cosine = range * cosine_;
    const double sine = range * sine_;
    Segment segment;
    segment.from = toWorld(from);
    segment.to = {segment.from.x() + (cosine * direction.x() - sine * direction.y()),
                  segment.from.y() + (sine * direction.x() + cosine * direction.y()),
                  segment.from.z() + range * direction.z()};
    return segment;
  }

 private:
  const Eigen::Vector3d& position_;
  double cosine_;
  double sine_;
};

/// Rays near an outline are looked up by the outline's position in the robot's frame, in a table of square cells with a
/// mask of rays each. Threads: const functions may run concurrently.
template <int count>
class RayRing : public RingGeometry<count> {
 public:
  /// @param range of the rays [m]
  RayRing(const RingGeometry<count>& geometry, double range) : RingGeometry<count>(geometry), range_(range) {
    rays_.resize(this->size());
    middle_.z() = this->centre.z();
    double farthest = 0.0;
    for (std::size_t i = 0; i < this->size(); ++i) {
      const Eigen::Vector3d start = this->from.col(static_cast<Eigen::Index>(i));
      const Eigen::Vector3d step = range * this->direction.col(static_cast<Eigen::Index>(i));
      const Eigen::Vector3d end = start + step;
      rays_.set(i, start.head<2>(), step.head<2>());
      farthest = std::max({farthest, start.head<2>().norm(), end.head<2>().norm()});
      bundle_radius_ = std::max({bundle_radius_, (start - middle_).norm() + kMargin, (end - middle_).norm() + kMargin});
      lowest_ = std::min({lowest_, start.z(), end.z()});
      highest_ = std::max({highest_, start.z(), end.z()});
    }
    rays_.measure();
    fillTables(farthest);
  }

  RayMask all() const { return ~RayMask{0} >> (64 - this->size()); }

  /// The bundle of all rays, without segments. @param pose of the robot
  RayBundle bundle(const Pose& pose) const {
    RayBundle rays;
    rays.radius = bundle_radius_;
    if (!pose.isUpright()) {
      rays.centre = pose.toWorld(middle_);
    } else {
      rays.centre = pose.position + middle_;  // independent of the robot's heading
      rays.lowest = pose.position.z() + lowest_ - kMargin;
      rays.highest = pose.position.z() + highest_ + kMargin;
    }
    return rays;
  }

  Segment ray(const UprightPose& pose, std::size_t i) const {
    const auto column = static_cast<Eigen::Index>(i);
    return pose.ray(this->from.col(column), this->direction.col(column), range_);
  }
  /// Computes the segments of all rays, for any pose. @param segments output, one for each sensor
  void aim(const Pose& pose, Span<Segment> segments) const {
    const Eigen::Matrix3d rotation = pose.orientation.toRotationMatrix();
    const Eigen::Matrix3d ranging_rotation = range_ * rotation;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const auto column = static_cast<Eigen::Index>(i);
      segments[i].from = rotation * this->from.col(column) + pose.position;
      segments[i].to = segments[i].from + ranging_rotation * this->direction.col(column);
    }
  }

  /// Calls at_circle(centre in the robot's frame, radius, mask of the rays near it) for each obstacle that is exactly a
  /// circle to the rays, and at_solid(solid, mask of the rays that may hit it) for each other one.
  /// @pre !obstacles.areAnywhere()
  template <class AtCircle, class AtSolid>
  void visitNear(const Obstacles& obstacles, const UprightPose& pose, AtCircle at_circle, AtSolid at_solid) const {
    for (const Obstacles::Circle& circle : obstacles.circles()) {
      const Eigen::Vector2d middle = pose.toRobot(circle.centre);
      const RayMask near = nearCircle(middle, circle.radius);
      if (near != 0 && circle.is_exact) {
        at_circle(middle, circle.radius, near);
      } else if (near != 0) {
        at_solid(circle.solid, near);
      }
    }
    for (const Obstacles::Box& box : obstacles.boxes()) {
      const RayMask near = lookUp(by_face_, pose.toRobot(box.nearestTo(pose.place())));
      if (near != 0) {
        at_solid(box.solid, near);
      }
    }
  }

  /// As FlatRays::entryInto. @param middle centre of the circle in the robot's frame
  double entryInto(const Eigen::Vector2d& middle, double circle_radius, std::size_t i) const {
    return rays_.entryInto(middle, circle_radius, i);
  }

 private:
  static constexpr int kCells = 40;        // of a table in each direction: some 15 mm wide for a footbot
  static constexpr double kMargin = 1e-6;  // m, for rounding

  using Table = std::array<RayMask, static_cast<std::size_t>(kCells) * kCells>;

  /// Rays near circles up to a radius, by the cell of the circle's centre.
  struct CircleTable {
    double radius;  // m
    Table near;
  };

  /// @param reach of the rays from the robot's origin [m]
  void fillTables(double reach) {
    const double usual_radius = this->radius + kMargin;  // other robots of the type are as wide as the ring
    half_side_ = reach + usual_radius;
    by_circle_[0].radius = usual_radius / 3.0;  // grippers, legs and the like
    by_circle_[1].radius = usual_radius;
    const double cell = 2.0 * half_side_ / kCells;
    inverse_cell_ = 1.0 / cell;
    const double half_diagonal = M_SQRT1_2 * cell + kMargin;
    for (int line = 0; line < kCells; ++line) {
      for (int column = 0; column < kCells; ++column) {
        const Eigen::Vector2d middle((column + 0.5) * cell - half_side_, (line + 0.5) * cell - half_side_);
        const std::size_t place = static_cast<std::size_t>(line) * kCells + static_cast<std::size_t>(column);
        for (CircleTable& table : by_circle_) {
          table.near[place] = rays_.nearPoint(middle, table.radius + half_diagonal);
        }
        by_face_[place] = beyondFace(middle, half_diagonal);
      }
    }
  }

  /// Rays that may hit a convex obstacle whose closest point to the robot's origin is at most `margin` from `nearest`.
  /// The obstacle lies beyond the line through that point perpendicular to the way to it. A point e lies beyond that
  /// line if the closest point is in the circle with the diameter from the origin to e (Thales).
  RayMask beyondFace(const Eigen::Vector2d& nearest, double margin) const {
    RayMask mask = 0;
    for (std::size_t i = 0; i < this->size(); ++i) {
      for (const Eigen::Vector2d& end : {rays_.from(i), Eigen::Vector2d(rays_.from(i) + rays_.step(i))}) {
        const bool is_beyond = (nearest - 0.5 * end).norm() <= 0.5 * end.norm() + margin;
        mask |= static_cast<RayMask>(is_beyond) << i;
      }
    }
    return mask;
  }

  RayMask nearCircle(const Eigen::Vector2d& middle, double circle_radius) const {
    for (const CircleTable& table : by_circle_) {
      if (circle_radius <= table.radius) {
        return lookUp(table.near, middle);
      }
    }
    return rays_.nearPoint(middle, circle_radius + kMargin);
  }

  RayMask lookUp(const Table& table, const Eigen::Vector2d& point) const {
    const double column = (point.x() + half_side_) * inverse_cell_;
    const double line = (point.y() + half_side_) * inverse_cell_;
    const bool is_inside = column >= 0.0 && column < kCells && line >= 0.0 && line < kCells;
    return is_inside ? table[static_cast<std::size_t>(line) * kCells + static_cast<std::size_t>(column)] : 0;
  }

  double range_;                                      // m
  Eigen::Vector3d middle_ = Eigen::Vector3d::Zero();  // on the z axis of the robot, at the height of the sensors [m]
  double bundle_radius_ = 0.0;                        // of a sphere around that point that contains all rays [m]
  double lowest_ = kInfinity;                         // lowest height of the rays, in the robot's frame, m
  double highest_ = -kInfinity;                       // highest height of the rays, in the robot's frame, m
  double half_side_ = 0.0;                            // of the tables, m
  double inverse_cell_ = 0.0;                         // 1/m
  FlatRays<static_cast<std::size_t>(RingGeometry<count>::kMost)> rays_;  // seen from above, in the robot's frame
  std::array<CircleTable, 2> by_circle_;                                 // by ascending radius
  Table by_face_;  // rays near a box, by the point of the box closest to the robot's origin
};

/// As Rings, for RayRing.
template <int count>
class RayRings {
 public:
  /// @throws ConfigError as ringOf
  std::shared_ptr<const RayRing<count>> of(const std::shared_ptr<const EntityModel>& model, const char* device,
                                           const std::vector<std::string>& names, double range) {
    const std::shared_ptr<const RingGeometry<count>> geometry = rings_.of(model, device, names);
    const auto found =
        std::find_if(ray_rings_.begin(), ray_rings_.end(), [&](const Found& one) { return one.geometry == geometry; });
    if (found != ray_rings_.end()) {
      return found->ring;
    }
    static SharedByModel<std::pair<std::vector<std::string>, double>, RayRing<count>> shared;
    ray_rings_.push_back(
        {geometry, shared.get(model, {names, range}, [&] { return RayRing<count>(*geometry, range); })});
    return ray_rings_.back().ring;
  }

 private:
  struct Found {
    std::shared_ptr<const RingGeometry<count>> geometry;
    std::shared_ptr<const RayRing<count>> ring;
  };

  Rings<count> rings_;
  std::vector<Found> ray_rings_;
};

}  // namespace swarmanoid::devices
