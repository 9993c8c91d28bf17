#include "swarmanoid_space/rays/led_shades.hpp"

#include <algorithm>
#include <cmath>

#include "inside_of.hpp"
#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid {
namespace {

// A LED this close to the end of a shape counts as outside, whichever way rounding goes (fraction of the line).
constexpr double kSameDepth = 1e-6;

constexpr double kSure = 1e-9;  // fraction; far above rounding errors

/// Returns whether a solid hides a LED. @param start, step in the solid's frame
bool isBehind(CollisionShape::Kind kind, const Eigen::Vector3d& half_extent, const Eigen::Vector3d& start,
              const Eigen::Vector3d& step) {
  const LinePart inside = insideOf(kind, half_extent, start, step);
  // a solid that continues behind the LED is a hull around it, or is not in front of it
  return !inside.isEmpty() && inside.to >= 0.0 && inside.to <= 1.0 + kSameDepth;
}

double least(double a, double b) { return a < b ? a : b; }
double most(double a, double b) { return a < b ? b : a; }

}  // namespace

void LedShades::begin(const EntityModel& model, Span<const JointState> joints) {
  SWARMANOID_EXPECTS(model.silhouettes.size() == model.shapes.size());
  SWARMANOID_EXPECTS(model.led_bounds.count == model.led_positions.size());
  model_ = &model;
  joints_ = joints;
  if (shades_.size() < model.shapes.size()) {
    shades_.resize(model.shapes.size());
  }
  for (std::size_t i = 0; i < model.shapes.size(); ++i) {
    shades_[i].is_placed = false;
  }
}

LedShades::Lines LedShades::linesFrom(const Eyes& eyes) const {
  const double way_in = eyes.axis.norm();
  return {std::max(0.0, way_in - eyes.radius), way_in + eyes.radius + model_->led_bounds.radius, eyes.lowest,
          eyes.highest};
}

/// Returns whether all lines pass over or under a shape, for any joint angle: most shapes of a robot hide no LED.
bool LedShades::isPassedBy(std::size_t number, const Lines& lines) const {
  const CollisionShape& shape = model_->shapes[number];
  if (shape.joint >= 0) {
    const EntityModel::Joint& joint = model_->joints[static_cast<std::size_t>(shape.joint)];
    if (joint.carrier >= 0 || joint.axis.x() != 0.0 || joint.axis.y() != 0.0) {
      return false;  // the joint may lift the shape
    }
  }
  constexpr double kSlack = 1e-4;  // m: above the lines' continuation behind LEDs, and above rounding errors
  const EntityModel::Silhouette& silhouette = model_->silhouettes[number];
  // up to this fraction of its length no line is as close to body z as the shape
  const double fraction = std::max(0.0, (lines.way_in - silhouette.radius - kSlack) / (lines.length + kSlack));
  const double lowest =
      std::min(lines.lowest + fraction * (model_->led_bounds.lowest - lines.lowest), model_->led_bounds.lowest);
  const double highest =
      std::max(lines.highest + fraction * (model_->led_bounds.highest - lines.highest), model_->led_bounds.highest);
  return silhouette.high < lowest - kSlack || silhouette.low > highest + kSlack;
}

const LedShades::Shade& LedShades::shadeOf(std::size_t number) {
  Shade& shade = shades_[number];
  if (!shade.is_placed) {
    const CollisionShape& at_rest = model_->shapes[number];
    const CollisionShape shape = at_rest.joint < 0 ? at_rest : placeOf(*model_, joints_, at_rest);
    shade = {true,           false,
             shape.kind,     (shape.half_extent.array() - kLedHeight).max(0.5 * shape.half_extent.array()),
             shape.position, shape.orientation.conjugate().toRotationMatrix()};
    if (shape.kind == CollisionShape::Kind::kCylinder && shade.to_shape(2, 2) == 1.0) {
      shade.to_shape.setIdentity();  // an upright cylinder is invariant under turns about its axis
    }
    shade.is_aligned = shade.to_shape.isIdentity(0.0);
  }
  return shade;
}

LedShades::Steps LedShades::stepsTo(const LedSet& asked, const Shade& shade, const Eigen::Vector3d& eye) const {
  Steps steps;
  visitLeds(asked, [&](std::size_t k) {
    const Eigen::Vector3d way = model_->led_positions[k] - eye;
    const Eigen::Vector3d step = shade.is_aligned ? way : Eigen::Vector3d(shade.to_shape * way);
    const std::size_t i = steps.count++;
    steps.led[i] = static_cast<std::uint8_t>(k);
    steps.x[i] = step.x();
    steps.y[i] = step.y();
    steps.z[i] = step.z();
  });
  return steps;
}

/// Decides by the point of each line that is closest to the axis, without a quotient or square root. Not sure where
/// rounding could decide, and where the line ends, or is closest to the axis, in an end face.
LedShades::Sure LedShades::behindCylinder(const Shade& shade, const Eigen::Vector3d& start, const Steps& steps) {
  const double squared_radius = shade.half_extent.x() * shade.half_extent.x();
  // positive where the result is sure
  Column hidden;
  Column free;
  for (std::size_t i = 0; i < steps.count; ++i) {  // without branches, so that compilers vectorise it
    const double x = steps.x[i];
    const double y = steps.y[i];
    const double a = x * x + y * y;
    const double b = start.x() * x + start.y() * y;
    const double led_x = start.x() + x;
    const double led_y = start.y() + y;
    const double outside = led_x * led_x + led_y * led_y - squared_radius * (1.0 + kSure);
    const double across = start.x() * y - start.y() * x;
    const double squared_across = across * across;
    const double after = -kSure * a - (a + b);  // positive: the line approaches the axis only beyond the LED
    const double beside = squared_across - squared_radius * a * (1.0 + kSure);
    free[i] = least(outside, most(after, beside));
    const double within = squared_radius * a * (1.0 - kSure) - squared_across;
    const double height = start.z() * a - steps.z[i] * b;
    const double between = shade.half_extent.z() * a * (1.0 - kSure) - std::abs(height);
    const double on_the_way = least(-kSure * a - b, a + b - kSure * a);
    hidden[i] = least(least(outside, on_the_way), least(within, between));
  }
  Sure sure;
  for (std::size_t i = 0; i < steps.count; ++i) {
    sure.hidden |= static_cast<std::uint64_t>(hidden[i] > 0.0) << steps.led[i];
    sure.free |= static_cast<std::uint64_t>(free[i] > 0.0) << steps.led[i];
  }
  return sure;
}

/// Seen from above, the eyes for which an upright cylinder hides a LED are behind the cylinder, between the two
/// tangents to it through the LED.
LedShades::Sure LedShades::behindCylinderForAll(const Shade& shade, const Eyes& eyes) const {
  Sure sure;
  if (shade.to_shape(2, 2) != 1.0) {
    return sure;
  }
  constexpr double kMargin = 1e-6;  // m: far above rounding errors, and above the lines' continuation behind LEDs
  const double far = eyes.radius + kMargin;
  const double cylinder = shade.half_extent.x();
  const double low = shade.position.z() - shade.half_extent.z() + kMargin;
  const double high = shade.position.z() + shade.half_extent.z() - kMargin;
  const bool is_level = eyes.lowest > low && eyes.highest < high;
  for (std::size_t k = 0; k < std::min(model_->led_positions.size(), EntityModel::kMaxLeds); ++k) {
    const double height = model_->led_positions[k].z();
    const Eigen::Vector2d led = (model_->led_positions[k] - shade.position).head<2>();
    const double way = led.norm();
    if (!(way > cylinder + kMargin)) {
      continue;
    }
    const Eigen::Vector2d inwards = led / -way;
    const Eigen::Vector2d to_eyes = eyes.axis - shade.position.head<2>() - led;
    const double ahead = inwards.dot(to_eyes);
    const double aside = std::abs(inwards.x() * to_eyes.y() - inwards.y() * to_eyes.x());
    const double sine = cylinder / way;  // of the angle between `inwards` and the tangents
    const double cosine = std::sqrt(1.0 - sine * sine);
    const double inside = ahead * sine - aside * cosine;  // distance from the closer tangent
    const bool is_beyond = ahead > way + far;             // the line passes the cylinder's axis
    const bool is_hidden = is_level && inside > far && is_beyond && height > low && height < high;
    sure.hidden |= static_cast<std::uint64_t>(is_hidden) << k;
    sure.free |= static_cast<std::uint64_t>(inside < -far) << k;
  }
  return sure;
}

/// Finds the lines that pass beside the sphere around a shape, or end before it.
LedShades::Sure LedShades::besideSphere(const Shade& shade, const Eigen::Vector3d& start, const Steps& steps) const {
  const double radius = shade.kind == CollisionShape::Kind::kSphere ? shade.half_extent.x() : shade.half_extent.norm();
  // lines continue a little behind LEDs
  const double farthest_led =
      model_->led_bounds.radius + std::max(std::abs(model_->led_bounds.lowest), std::abs(model_->led_bounds.highest));
  const double way = start.norm() + shade.position.norm() + farthest_led;
  const double reach = radius + 2.0 * kSameDepth * (way + radius);
  const double squared_reach = reach * reach;
  Column free;  // positive where the result is sure
  for (std::size_t i = 0; i < steps.count; ++i) {
    const double x = steps.x[i];
    const double y = steps.y[i];
    const double z = steps.z[i];
    const double a = x * x + y * y + z * z;
    const double b = start.x() * x + start.y() * y + start.z() * z;
    const double led_x = start.x() + x;
    const double led_y = start.y() + y;
    const double led_z = start.z() + z;
    const double outside = led_x * led_x + led_y * led_y + led_z * led_z - squared_reach;
    const double across_x = start.y() * z - start.z() * y;
    const double across_y = start.z() * x - start.x() * z;
    const double across_z = start.x() * y - start.y() * x;
    const double beside = across_x * across_x + across_y * across_y + across_z * across_z - squared_reach * a;
    free[i] = least(outside, most(-kSure * a - (a + b), beside));
  }
  Sure sure;
  for (std::size_t i = 0; i < steps.count; ++i) {
    sure.free |= static_cast<std::uint64_t>(free[i] > 0.0) << steps.led[i];
  }
  return sure;
}

void LedShades::addHidden(const Shade& shade, const Eigen::Vector3d& eye, const LedSet& asked, LedSet& hidden) const {
  const Eigen::Vector3d start = shade.to_shape * (eye - shade.position);
  const LedSet left = asked & ~hidden;
  const Steps steps = stepsTo(left, shade, eye);
  const Sure sure = shade.kind == CollisionShape::Kind::kCylinder ? behindCylinder(shade, start, steps)
                                                                  : besideSphere(shade, start, steps);
  hidden |= LedSet(sure.hidden);
  visitLeds(left & ~LedSet(sure.hidden | sure.free), [&](std::size_t k) {
    hidden[k] = isBehind(shade.kind, shade.half_extent, start, shade.to_shape * (model_->led_positions[k] - eye));
  });
}

LedSet LedShades::hidden(const Eigen::Vector3d& eye, const LedSet& asked) {
  LedSet hidden;
  const Lines lines = linesFrom({eye.head<2>(), 0.0, eye.z(), eye.z()});
  for (std::size_t i = 0; i < model_->shapes.size(); ++i) {
    if (!isPassedBy(i, lines)) {
      addHidden(shadeOf(i), eye, asked, hidden);
    }
  }
  return hidden;
}

LedShades::SameForAll LedShades::sameForAll(const Eyes& eyes) {
  const Lines lines = linesFrom(eyes);
  SameForAll same{{}, ~LedSet()};
  for (std::size_t i = 0; i < model_->shapes.size(); ++i) {
    if (!isPassedBy(i, lines)) {
      const Shade& shade = shadeOf(i);
      const bool is_cylinder = shade.kind == CollisionShape::Kind::kCylinder;
      const Sure sure = is_cylinder ? behindCylinderForAll(shade, eyes) : Sure{};
      same.hidden |= LedSet(sure.hidden);
      same.free &= LedSet(sure.free);
    }
  }
  return same;
}

}  // namespace swarmanoid
