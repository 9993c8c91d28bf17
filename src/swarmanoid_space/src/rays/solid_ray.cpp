#include "swarmanoid_space/rays/solid_ray.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "swarmanoid_space/rays/line_part.hpp"

namespace swarmanoid {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

// A LED this near to where a shape ends counts as outside, on whichever side rounding puts it (fraction of the way).
constexpr double kSameDepth = 1e-6;

/// The part of a line that is inside a shape. @param start, step in the shape's frame
LinePart insideOf(CollisionShape::Kind kind, const Eigen::Vector3d& half_extent, const Eigen::Vector3d& start,
                  const Eigen::Vector3d& step) {
  LinePart inside = LinePart::whole();
  switch (kind) {
    case CollisionShape::Kind::kBox:
      for (int axis = 0; axis < 3; ++axis) {
        inside.clipToSlab(start[axis], step[axis], -half_extent[axis], half_extent[axis]);
      }
      break;
    case CollisionShape::Kind::kCylinder:
      inside.clipToSlab(start.z(), step.z(), -half_extent.z(), half_extent.z());
      inside.clipToRound(Eigen::Vector2d(start.head<2>()), Eigen::Vector2d(step.head<2>()), half_extent.x());
      break;
    case CollisionShape::Kind::kSphere:
      inside.clipToRound(start, step, half_extent.x());
      break;
  }
  return inside;
}

/// How high and how low the lines from an eye to LEDs go, along body z [m].
struct HeightsOfLines {
  double lowest;
  double highest;
};

HeightsOfLines heightsOf(const EntityModel& model, const Eigen::Vector3d& eye, const LedSet& asked) {
  HeightsOfLines heights{eye.z(), eye.z()};
  for (std::size_t k = 0; k < std::min(model.led_positions.size(), asked.size()); ++k) {
    if (asked[k]) {
      heights.lowest = std::min(heights.lowest, model.led_positions[k].z());
      heights.highest = std::max(heights.highest, model.led_positions[k].z());
    }
  }
  return heights;
}

/// Whether all lines pass over or under a shape, however its joint has turned it: most shapes of a robot hide no LED.
bool isPassedBy(const EntityModel& model, const CollisionShape& shape, const HeightsOfLines& lines) {
  if (shape.joint >= 0) {
    const EntityModel::Joint& joint = model.joints[static_cast<std::size_t>(shape.joint)];
    if (joint.carrier >= 0 || joint.axis.x() != 0.0 || joint.axis.y() != 0.0) {
      return false;  // it may lift the shape
    }
  }
  constexpr double kSlack = 1e-4;  // m: more than lines go on behind LEDs, and than rounding
  const Eigen::Vector3d up = shape.orientation.conjugate() * Eigen::Vector3d::UnitZ();
  const bool is_sphere = shape.kind == CollisionShape::Kind::kSphere;
  const double reach = is_sphere ? shape.half_extent.x() : up.cwiseAbs().dot(shape.half_extent);
  return shape.position.z() + reach < lines.lowest - kSlack || shape.position.z() - reach > lines.highest + kSlack;
}

/// Adds the LEDs that one shape hides. @param shape where its joint has turned it
void addHidden(const CollisionShape& shape, const EntityModel& model, const Eigen::Vector3d& eye, const LedSet& asked,
               LedSet& hidden) {
  const Eigen::Vector3d half_extent = (shape.half_extent.array() - kLedHeight).max(0.5 * shape.half_extent.array());
  const Eigen::Matrix3d to_shape = shape.orientation.conjugate().toRotationMatrix();
  const Eigen::Vector3d start = to_shape * (eye - shape.position);
  for (std::size_t k = 0; k < std::min(model.led_positions.size(), asked.size()); ++k) {
    if (!asked[k] || hidden[k]) {
      continue;
    }
    const Eigen::Vector3d step = to_shape * (model.led_positions[k] - eye);
    const LinePart inside = insideOf(shape.kind, half_extent, start, step);
    // what goes on behind the LED is a hull around it, or does not stand before it
    hidden[k] = !inside.isEmpty() && inside.to >= 0.0 && inside.to <= 1.0 + kSameDepth;
  }
}

}  // namespace

double closestHit(const Segment& segment, const EntityModel& model, const Pose& pose) {
  const Eigen::Quaterniond to_body = pose.orientation.conjugate();
  const Eigen::Vector3d start = to_body * (segment.from - pose.position);
  const Eigen::Vector3d step = to_body * (segment.to - segment.from);
  double first = kNever;
  for (const CollisionShape& shape : model.shapes) {
    const Eigen::Quaterniond to_shape = shape.orientation.conjugate();
    const LinePart inside =
        insideOf(shape.kind, shape.half_extent, to_shape * (start - shape.position), to_shape * step);
    if (!inside.isEmpty() && inside.to >= 0.0 && inside.from <= 1.0) {
      first = std::min(first, std::max(inside.from, 0.0));
    }
  }
  return first;
}

LedSet hiddenLeds(const EntityModel& model, Span<const JointState> joints, const Eigen::Vector3d& eye,
                  const LedSet& asked) {
  LedSet hidden;
  const HeightsOfLines lines = heightsOf(model, eye, asked);
  for (const CollisionShape& shape : model.shapes) {
    if (isPassedBy(model, shape, lines)) {
      continue;
    }
    if (shape.joint < 0) {
      addHidden(shape, model, eye, asked, hidden);
    } else {
      addHidden(placeOf(model, joints, shape), model, eye, asked, hidden);
    }
  }
  return hidden;
}

}  // namespace swarmanoid
