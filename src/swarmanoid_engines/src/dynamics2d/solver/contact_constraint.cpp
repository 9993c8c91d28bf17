#include <algorithm>
#include <cmath>

#include "dynamics2d/solver/constraints.hpp"

namespace swarmanoid::dynamics2d {
namespace {

/// Depth to which bodies may rest in each other [m].
constexpr double kSlop = 1e-5;
/// Limit of one correction of a depth [m]: larger corrections of deep overlaps would throw bodies through others.
constexpr double kMostCorrection = 5e-3;

Eigen::Vector2d leftOf(const Eigen::Vector2d& v) { return {-v.y(), v.x()}; }

}  // namespace

void SolverBody::shift(const Eigen::Vector2d& impulse, const Eigen::Vector2d& arm, double turn_impulse) {
  if (inverse_mass == 0.0) {
    return;
  }
  const double turn = inverse_inertia * (planar::cross(arm, impulse) + turn_impulse);
  const Eigen::Vector2d way = inverse_mass * impulse;
  pose = planar::PlacedPose::nearby(pose, way, turn);
  shifted += way.norm() + radius * std::abs(turn);
}

void ContactConstraint::prepare(const SolverBodies& bodies, double step) {
  constexpr double kFastestOut = 0.3;  // m/s: separation speed from a mirror placed onto a body
  const SolverBody& body_a = bodies[static_cast<std::size_t>(a)];
  const SolverBody& body_b = bodies[static_cast<std::size_t>(b)];
  const bool has_limit = std::isfinite(most);
  coupling_ = 0.0;
  for (int i = 0; i < patch.count; ++i) {
    Point& point = points[static_cast<std::size_t>(i)];
    const Facing facing = facingAt(patch, i, body_a.pose, body_b.pose);
    normal = facing.normal;
    point.arm_a = facing.arm_a;
    point.arm_b = facing.arm_b;
    point.normal_mass = 1.0 / (body_a.yieldAlong(point.arm_a, normal) + body_b.yieldAlong(point.arm_b, normal));
    const Eigen::Vector2d across = leftOf(normal);
    point.tangent_mass = 1.0 / (body_a.yieldAlong(point.arm_a, across) + body_b.yieldAlong(point.arm_b, across));
    point.approach = std::max(facing.gap, 0.0) / step;
    point.speed_before = normal.dot(body_b.velocityAt(point.arm_b) - body_a.velocityAt(point.arm_a));
    point.allowed_depth = has_limit ? std::max(0.0, -facing.gap - kFastestOut * step) : 0.0;
  }
  if (patch.count == 2) {
    constexpr double kRegular = 1e-3;
    const auto turns = [&](const SolverBody& body, const Eigen::Vector2d& arm_0, const Eigen::Vector2d& arm_1) {
      return body.inverse_mass + body.inverse_inertia * planar::cross(arm_0, normal) * planar::cross(arm_1, normal);
    };
    cross_yield_ = turns(body_a, points[0].arm_a, points[1].arm_a) + turns(body_b, points[0].arm_b, points[1].arm_b);
    const double product = 1.0 / (points[0].normal_mass * points[1].normal_mass);
    const double determinant = product - cross_yield_ * cross_yield_;
    coupling_ = determinant > kRegular * product ? 1.0 / determinant : 0.0;
  }
}

void ContactConstraint::startFrom(const ContactConstraint& before, SolverBodies& bodies) {
  for (int i = 0; i < patch.count; ++i) {
    for (int k = 0; k < before.patch.count; ++k) {
      if (patch.points[static_cast<std::size_t>(i)].key != before.patch.points[static_cast<std::size_t>(k)].key) {
        continue;
      }
      Point& point = points[static_cast<std::size_t>(i)];
      point.impulse = before.points[static_cast<std::size_t>(k)].impulse;
      point.rub = before.points[static_cast<std::size_t>(k)].rub;
      const Eigen::Vector2d impulse = point.impulse * normal + point.rub * leftOf(normal);
      bodies[static_cast<std::size_t>(a)].push(-impulse, point.arm_a);
      bodies[static_cast<std::size_t>(b)].push(impulse, point.arm_b);
    }
  }
}

double ContactConstraint::solve(SolverBodies& bodies) {
  SolverBody& body_a = bodies[static_cast<std::size_t>(a)];
  SolverBody& body_b = bodies[static_cast<std::size_t>(b)];
  const Eigen::Vector2d across = leftOf(normal);
  double change = 0.0;
  const auto give = [&](const Point& point, const Eigen::Vector2d& direction, double mass, double impulse) {
    body_a.push(-impulse * direction, point.arm_a);
    body_b.push(impulse * direction, point.arm_b);
    change = std::max(change, std::abs(impulse) / mass);
  };
  for (int i = 0; i < patch.count; ++i) {
    Point& point = points[static_cast<std::size_t>(i)];
    const double slip = across.dot(body_b.velocityAt(point.arm_b) - body_a.velocityAt(point.arm_a));
    const double limit = friction * point.impulse;
    const double rub = std::clamp(point.rub - point.tangent_mass * slip, -limit, limit);
    give(point, across, point.tangent_mass, rub - point.rub);
    point.rub = rub;
  }
  const std::array<double, 2> impulses = normalImpulses(body_a, body_b);
  for (int i = 0; i < patch.count; ++i) {
    Point& point = points[static_cast<std::size_t>(i)];
    const double impulse = impulses[static_cast<std::size_t>(i)];
    give(point, normal, point.normal_mass, impulse - point.impulse);
    point.impulse = impulse;
  }
  return change;
}

std::array<double, 2> ContactConstraint::normalImpulses(const SolverBody& body_a, const SolverBody& body_b) const {
  std::array<double, 2> wrong{};  // speeds that the impulses have to cancel [m/s]
  for (int i = 0; i < patch.count; ++i) {
    const Point& point = points[static_cast<std::size_t>(i)];
    wrong[static_cast<std::size_t>(i)] =
        normal.dot(body_b.velocityAt(point.arm_b) - body_a.velocityAt(point.arm_a)) + point.approach;
  }
  const auto alone = [&](std::size_t i, double speed) {
    return std::clamp(points[i].impulse - points[i].normal_mass * speed, 0.0, most);
  };
  if (patch.count < 2 || coupling_ <= 0.0) {
    std::array<double, 2> result{alone(0, wrong[0]), 0.0};
    if (patch.count == 2) {
      const double change = result[0] - points[0].impulse;
      result[1] = alone(1, wrong[1] + cross_yield_ * change);
    }
    return result;
  }
  // Solved together: otherwise the bodies would turn about one point after the other, for hundreds of sweeps.
  const double yield_0 = 1.0 / points[0].normal_mass;
  const double yield_1 = 1.0 / points[1].normal_mass;
  const double both_0 = points[0].impulse - coupling_ * (yield_1 * wrong[0] - cross_yield_ * wrong[1]);
  const double both_1 = points[1].impulse - coupling_ * (yield_0 * wrong[1] - cross_yield_ * wrong[0]);
  if (both_0 >= 0.0 && both_1 >= 0.0) {
    return {std::min(both_0, most), std::min(both_1, most)};
  }
  // one point carries all of the load
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    const std::size_t other = 1 - i;
    const double without = wrong[i] - cross_yield_ * points[other].impulse;
    const double impulse = alone(i, without);
    const double speed =
        wrong[other] - points[other].impulse / points[other].normal_mass + cross_yield_ * (impulse - points[i].impulse);
    if (impulse > 0.0 && speed >= 0.0) {
      return i == 0 ? std::array<double, 2>{impulse, 0.0} : std::array<double, 2>{0.0, impulse};
    }
  }
  return {0.0, 0.0};
}

void ContactConstraint::bounce(SolverBodies& bodies, double restitution, double slowest) {
  SolverBody& body_a = bodies[static_cast<std::size_t>(a)];
  SolverBody& body_b = bodies[static_cast<std::size_t>(b)];
  for (int i = 0; i < patch.count; ++i) {
    Point& point = points[static_cast<std::size_t>(i)];
    if (point.speed_before > -slowest || point.impulse <= 0.0) {
      continue;
    }
    const double speed = normal.dot(body_b.velocityAt(point.arm_b) - body_a.velocityAt(point.arm_a));
    const double impulse =
        std::max(point.impulse - point.normal_mass * (speed + restitution * point.speed_before), 0.0);
    body_a.push((point.impulse - impulse) * normal, point.arm_a);
    body_b.push((impulse - point.impulse) * normal, point.arm_b);
    point.impulse = impulse;
  }
}

double ContactConstraint::depthOf(int point, const Facing& facing) const {
  return -facing.gap - points[static_cast<std::size_t>(point)].allowed_depth - kSlop;
}

double ContactConstraint::correct(SolverBodies& bodies) {
  SolverBody& body_a = bodies[static_cast<std::size_t>(a)];
  SolverBody& body_b = bodies[static_cast<std::size_t>(b)];
  double deepest = 0.0;
  for (int i = 0; i < patch.count; ++i) {
    Point& point = points[static_cast<std::size_t>(i)];
    const double shifted = body_a.shifted + body_b.shifted;
    if (shifted <= point.clear_until) {
      continue;
    }
    const Facing facing = facingAt(patch, i, body_a.pose, body_b.pose);
    const double depth = depthOf(i, facing);
    if (depth <= 0.0) {
      point.clear_until = shifted - depth;
      continue;
    }
    deepest = std::max(deepest, depth);
    const double yield =
        body_a.yieldAlong(facing.arm_a, facing.normal) + body_b.yieldAlong(facing.arm_b, facing.normal);
    const Eigen::Vector2d impulse = std::min(depth, kMostCorrection) / yield * facing.normal;
    body_a.shift(-impulse, facing.arm_a);
    body_b.shift(impulse, facing.arm_b);
  }
  return deepest;
}

}  // namespace swarmanoid::dynamics2d
