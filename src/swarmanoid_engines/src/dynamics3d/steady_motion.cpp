#include "dynamics3d/steady_motion.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics3d/mechanisms/treels.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;

// After this time, the rest of a change moves a body by parts of a micrometre until it has died away: it decays by a
// factor of e in 40 ms, by the springs under robots.
constexpr double kSameTime = 0.1 - 1e-9;  // s
constexpr double kSameSpeed = 1e-5;       // m/s2, along the ground
constexpr double kSameTurn = 1e-4;        // rad/s2, about the vertical
constexpr double kStillSpeed = 1e-6;      // m/s, up and down
constexpr double kStillTurn = 2e-5;       // rad/s, of tipping
constexpr double kRounding = 1e-6;        // m

/// Whether only the ground acts on the body.
bool isFree(const Body& body) {
  return body.links.empty() && body.holding == nullptr && !body.turret.isCommanded() &&
         !body.flight_command.is_driven && dBodyGetNumJoints(body.rigid) == 0;
}

}  // namespace

void noteStep(Body& body, double step) {
  const Vector3d linear = toVector(dBodyGetLinearVel(body.rigid));
  const Vector3d angular = toVector(dBodyGetAngularVel(body.rigid));
  const Vector3d own_linear = toQuaternion(dBodyGetQuaternion(body.rigid)).conjugate() * linear;
  Steadiness& steadiness = body.steadiness;
  const bool is_same = isFree(body) && std::abs(linear.z()) < kStillSpeed && angular.head<2>().norm() < kStillTurn &&
                       (own_linear - steadiness.linear).norm() < kSameSpeed * step &&
                       std::abs(angular.z() - steadiness.turn_rate) < kSameTurn * step;
  steadiness.linear = own_linear;
  steadiness.turn_rate = angular.z();
  steadiness.time = is_same ? steadiness.time + step : 0.0;
}

bool movesSteadily(const Body& body) {
  return isFree(body) && body.steadiness.time >= kSameTime && (!body.model->wheels || runsAsCommanded(body));
}

Eigen::AlignedBox3d boxAroundWay(const Body& body, const Eigen::AlignedBox3d& box, double tick) {
  const Vector3d centre = toVector(dBodyGetPosition(body.rigid));
  const double reach = (box.max() - centre).cwiseAbs().cwiseMax((box.min() - centre).cwiseAbs()).head<2>().norm();
  const double speed = toVector(dBodyGetLinearVel(body.rigid)).head<2>().norm();
  const double way = (speed + reach * std::abs(dBodyGetAngularVel(body.rigid)[2])) * tick + kRounding;
  const Vector3d room(way, way, kRounding);
  return {box.min() - room, box.max() + room};
}

void moveOn(Body& body, int steps, double step) {
  const Vector3d velocity = toVector(dBodyGetLinearVel(body.rigid));
  const double turn_rate = dBodyGetAngularVel(body.rigid)[2];
  // in each step ODE turns a body by this angle, and moves it with its velocity at the step's end: the sum of the
  // turned velocities is a geometric series
  const double turn = 2.0 * std::atan(0.5 * turn_rate * step);
  const double half_sine = std::sin(0.5 * turn);
  const double length = half_sine == 0.0 ? steps : std::sin(0.5 * steps * turn) / half_sine;
  const Eigen::Rotation2Dd to_middle(0.5 * (steps + 1) * turn);
  const Eigen::Rotation2Dd to_end(steps * turn);
  Vector3d position = toVector(dBodyGetPosition(body.rigid));
  position.head<2>() += step * length * (to_middle * velocity.head<2>());
  const Eigen::Vector2d end_velocity = to_end * velocity.head<2>();
  const Eigen::Quaterniond turned(Eigen::AngleAxisd(to_end.angle(), Vector3d::UnitZ()));
  setBodyPose(body.rigid, position, (turned * toQuaternion(dBodyGetQuaternion(body.rigid))).normalized());
  dBodySetLinearVel(body.rigid, end_velocity.x(), end_velocity.y(), 0.0);
  dBodySetAngularVel(body.rigid, 0.0, 0.0, turn_rate);
}

}  // namespace swarmanoid::dynamics3d
