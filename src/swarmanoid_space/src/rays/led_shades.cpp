#include "swarmanoid_space/rays/led_shades.hpp"

#include <algorithm>
#include <cmath>

#include "inside_of.hpp"
#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid {
namespace {

// A LED this near to where a shape ends counts as outside, on whichever side rounding puts it (fraction of the way).
constexpr double kSameDepth = 1e-6;

/// How high and how low the lines from an eye to LEDs go, along body z [m].
struct HeightsOfLines {
  double lowest;
  double highest;
};

HeightsOfLines heightsOf(const EntityModel& model, const Eigen::Vector3d& eye, const LedSet& asked) {
  HeightsOfLines heights{eye.z(), eye.z()};
  visitLeds(asked, [&](std::size_t k) {
    heights.lowest = std::min(heights.lowest, model.led_positions[k].z());
    heights.highest = std::max(heights.highest, model.led_positions[k].z());
  });
  return heights;
}

/// Whether all lines pass over or under a shape, however its joint has turned it: most shapes of a robot hide no LED.
bool isPassedBy(const EntityModel& model, std::size_t number, const HeightsOfLines& lines) {
  const CollisionShape& shape = model.shapes[number];
  if (shape.joint >= 0) {
    const EntityModel::Joint& joint = model.joints[static_cast<std::size_t>(shape.joint)];
    if (joint.carrier >= 0 || joint.axis.x() != 0.0 || joint.axis.y() != 0.0) {
      return false;  // it may lift the shape
    }
  }
  constexpr double kSlack = 1e-4;  // m: more than lines go on behind LEDs, and than rounding
  const EntityModel::Silhouette& silhouette = model.silhouettes[number];
  return silhouette.high < lines.lowest - kSlack || silhouette.low > lines.highest + kSlack;
}

enum class Seen { kFree, kHidden, kUnsure };

/// Whether a cylinder hides a LED, from where the line is nearest to its axis: no quotient, no square root. Unsure
/// where rounding could decide, and where the line ends or comes nearest in a face. @param start, step in its frame
Seen behindCylinder(const Eigen::Vector3d& half_extent, const Eigen::Vector3d& start, const Eigen::Vector3d& step) {
  constexpr double kSure = 1e-9;  // as a fraction; far more than is rounded
  const double squared_radius = half_extent.x() * half_extent.x();
  const double a = step.head<2>().squaredNorm();
  const double b = start.head<2>().dot(step.head<2>());
  const Eigen::Vector2d led = (start + step).head<2>();
  if (led.squaredNorm() <= squared_radius * (1.0 + kSure)) {
    return Seen::kUnsure;
  }
  if (a + b < -kSure * a) {
    return Seen::kFree;  // it goes nearer to the axis beyond the LED only
  }
  const double across = start.x() * step.y() - start.y() * step.x();
  if (across * across > squared_radius * a * (1.0 + kSure)) {
    return Seen::kFree;
  }
  const bool is_before = b < -kSure * a;
  const bool is_inside = across * across < squared_radius * a * (1.0 - kSure) &&
                         std::abs(start.z() * a - step.z() * b) < half_extent.z() * a * (1.0 - kSure);
  return is_before && a + b > kSure * a && is_inside ? Seen::kHidden : Seen::kUnsure;
}

/// Whether a solid hides a LED. @param start, step in its frame
bool isBehind(CollisionShape::Kind kind, const Eigen::Vector3d& half_extent, const Eigen::Vector3d& start,
              const Eigen::Vector3d& step) {
  const Seen seen = kind == CollisionShape::Kind::kCylinder ? behindCylinder(half_extent, start, step) : Seen::kUnsure;
  if (seen != Seen::kUnsure) {
    return seen == Seen::kHidden;
  }
  const LinePart inside = insideOf(kind, half_extent, start, step);
  // what goes on behind the LED is a hull around it, or does not stand before it
  return !inside.isEmpty() && inside.to >= 0.0 && inside.to <= 1.0 + kSameDepth;
}

}  // namespace

void LedShades::begin(const EntityModel& model, Span<const JointState> joints) {
  SWARMANOID_EXPECTS(model.silhouettes.size() == model.shapes.size());
  model_ = &model;
  joints_ = joints;
  if (shades_.size() < model.shapes.size()) {
    shades_.resize(model.shapes.size());
  }
  for (std::size_t i = 0; i < model.shapes.size(); ++i) {
    shades_[i].is_placed = false;
  }
}

const LedShades::Shade& LedShades::shadeOf(std::size_t number) {
  Shade& shade = shades_[number];
  if (!shade.is_placed) {
    const CollisionShape& at_rest = model_->shapes[number];
    const CollisionShape shape = at_rest.joint < 0 ? at_rest : placeOf(*model_, joints_, at_rest);
    shade = {true, shape.kind, (shape.half_extent.array() - kLedHeight).max(0.5 * shape.half_extent.array()),
             shape.position, shape.orientation.conjugate().toRotationMatrix()};
  }
  return shade;
}

void LedShades::addHidden(const Shade& shade, const Eigen::Vector3d& eye, const LedSet& asked, LedSet& hidden) const {
  const Eigen::Vector3d start = shade.to_shape * (eye - shade.position);
  visitLeds(asked & ~hidden, [&](std::size_t k) {
    hidden[k] = isBehind(shade.kind, shade.half_extent, start, shade.to_shape * (model_->led_positions[k] - eye));
  });
}

LedSet LedShades::hidden(const Eigen::Vector3d& eye, const LedSet& asked) {
  LedSet hidden;
  const HeightsOfLines lines = heightsOf(*model_, eye, asked);
  for (std::size_t i = 0; i < model_->shapes.size(); ++i) {
    if (!isPassedBy(*model_, i, lines)) {
      addHidden(shadeOf(i), eye, asked, hidden);
    }
  }
  return hidden;
}

}  // namespace swarmanoid
