#include "swarmanoid_space/solid_ray.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swarmanoid {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

// A lamp this near to where a shape ends counts as outside, on whichever side rounding puts it (fraction of the sight).
constexpr double kSameDepth = 1e-6;

/// The part of a segment that is inside something: from `enter` to `leave`, as fractions.
struct Inside {
  double enter = -kNever;
  double leave = kNever;

  void clip(double from, double to) {
    enter = std::max(enter, from);
    leave = std::min(leave, to);
  }
};

void clipToSlab(Inside& inside, double start, double step, double half_width) {
  if (step == 0.0) {
    if (std::abs(start) > half_width) {
      inside.clip(kNever, -kNever);
    }
    return;
  }
  const double a = (-half_width - start) / step;
  const double b = (half_width - start) / step;
  inside.clip(std::min(a, b), std::max(a, b));
}

/// Clips to |p + t s|^2 <= radius^2, in as many dimensions as the vectors have.
template <class Vector>
void clipToRound(Inside& inside, const Vector& start, const Vector& step, double radius) {
  const double a = step.squaredNorm();
  const double b = start.dot(step);
  const double c = start.squaredNorm() - radius * radius;
  if (a == 0.0) {
    if (c > 0.0) {
      inside.clip(kNever, -kNever);
    }
    return;
  }
  const double discriminant = b * b - a * c;
  if (discriminant < 0.0) {
    inside.clip(kNever, -kNever);
    return;
  }
  const double root = std::sqrt(discriminant);
  inside.clip((-b - root) / a, (-b + root) / a);
}

Inside insideOf(const CollisionShape& shape, const Eigen::Vector3d& start, const Eigen::Vector3d& step) {
  Inside inside;
  switch (shape.kind) {
    case CollisionShape::Kind::kBox:
      for (int axis = 0; axis < 3; ++axis) {
        clipToSlab(inside, start[axis], step[axis], shape.half_extent[axis]);
      }
      break;
    case CollisionShape::Kind::kCylinder:
      clipToSlab(inside, start.z(), step.z(), shape.half_extent.z());
      clipToRound(inside, Eigen::Vector2d(start.head<2>()), Eigen::Vector2d(step.head<2>()), shape.half_extent.x());
      break;
    case CollisionShape::Kind::kSphere:
      clipToRound(inside, start, step, shape.half_extent.x());
      break;
  }
  return inside;
}

CollisionShape withoutSkin(CollisionShape shape) {
  shape.half_extent = (shape.half_extent.array() - kLampHeight).max(0.5 * shape.half_extent.array());
  return shape;
}

/// A segment in the body frame.
struct BodySegment {
  Eigen::Vector3d start;
  Eigen::Vector3d step;

  BodySegment(const Segment& segment, const Pose& pose) {
    const Eigen::Quaterniond to_body = pose.orientation.conjugate();
    start = to_body * (segment.from - pose.position);
    step = to_body * (segment.to - segment.from);
  }

  Inside insideOf(const CollisionShape& shape) const {
    const Eigen::Quaterniond to_shape = shape.orientation.conjugate();
    return swarmanoid::insideOf(shape, to_shape * (start - shape.position), to_shape * step);
  }
};

}  // namespace

double firstMeeting(const Segment& segment, const EntityModel& model, const Pose& pose) {
  const BodySegment way(segment, pose);
  double first = kNever;
  for (const CollisionShape& shape : model.shapes) {
    const Inside inside = way.insideOf(shape);
    if (inside.enter <= inside.leave && inside.leave >= 0.0 && inside.enter <= 1.0) {
      first = std::min(first, std::max(inside.enter, 0.0));
    }
  }
  return first;
}

bool hidesOwnLamp(const Segment& sight, const EntityModel& model, const JointState* joints, const Pose& pose) {
  const BodySegment way(sight, pose);
  return std::any_of(model.shapes.begin(), model.shapes.end(), [&](const CollisionShape& shape) {
    const Inside inside = way.insideOf(withoutSkin(shape.joint < 0 ? shape : placeOf(model, joints, shape)));
    // what goes on behind the lamp is a hull around it, or does not stand before it
    return inside.enter <= inside.leave && inside.leave >= 0.0 && inside.leave <= 1.0 + kSameDepth;
  });
}

}  // namespace swarmanoid
