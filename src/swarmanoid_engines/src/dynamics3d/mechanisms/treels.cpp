#include "dynamics3d/mechanisms/treels.hpp"

#include <algorithm>
#include <cmath>

namespace swarmanoid::dynamics3d {
namespace {

// Spring and damper of the balls that keep a robot from tipping.
constexpr double kSupportStiffness = 1e5;  // N/m
constexpr double kSupportDamping = 800.0;  // N s/m

/// Commanded rim speed [m/s]. @param side 0 left, 1 right
double wantedSpeed(const Body& robot, int side) {
  const WheelsCommand& command = robot.wheels_command;
  return (side == 0 ? command.left : command.right) * robot.model->wheels->radius;
}

}  // namespace

void takeSpeed(Body& robot, const Twist& twist) {
  const Eigen::Quaterniond turn = robot.currentPose().orientation;
  const double ahead = (turn * Eigen::Vector3d::UnitX()).dot(twist.linear);
  const double turning = 0.5 * robot.model->wheels->separation * (turn * Eigen::Vector3d::UnitZ()).dot(twist.angular);
  robot.treels.rim_speed[0] = ahead - turning;
  robot.treels.rim_speed[1] = ahead + turning;
}

void turnWheels(const Body& robot, WheelTurns& turns) {
  turns.left += robot.treels.run[0] / robot.model->wheels->radius;
  turns.right += robot.treels.run[1] / robot.model->wheels->radius;
}

void followCommand(Body& robot, double step) {
  const double most = kTreelAcceleration * step;
  for (int side = 0; side < 2; ++side) {
    double& speed = robot.treels.rim_speed[side];
    speed += std::clamp(wantedSpeed(robot, side) - speed, -most, most);
    robot.treels.run[side] += speed * step;
  }
}

bool runsAsCommanded(const Body& robot) {
  constexpr double kAsCommanded = 1e-12;  // m/s
  const double* speed = robot.treels.rim_speed;
  return std::abs(speed[0] - wantedSpeed(robot, 0)) < kAsCommanded &&
         std::abs(speed[1] - wantedSpeed(robot, 1)) < kAsCommanded;
}

void driveContact(const Body& robot, const Solid& solid, const Settings& settings, double step, dContact& contact) {
  constexpr double kLeastAcross = 0.3;
  dSurfaceParameters& surface = contact.surface;
  const dReal* axes = dBodyGetRotation(robot.rigid);
  const Eigen::Vector3d left(axes[1], axes[5], axes[9]);
  const Eigen::Vector3d normal = toVector(contact.geom.normal);
  Eigen::Vector3d ahead = left.cross(normal);
  const double across = ahead.norm();
  if (across < kLeastAcross) {
    return;
  }
  if (solid.kind == Solid::Kind::kSupport) {
    const double both = step * kSupportStiffness + kSupportDamping;
    surface.mode |= dContactSoftERP | dContactSoftCFM;
    surface.soft_erp = step * kSupportStiffness / both;
    surface.soft_cfm = 1.0 / both;
  }
  ahead /= across;
  // along the middle of the step's arc: the direction at its start would lead out of a curve
  const double half_turn = 0.5 * step * normal.dot(toVector(dBodyGetAngularVel(robot.rigid)));
  ahead = (ahead + half_turn * normal.cross(ahead)).normalized();
  surface.mode |= dContactFDir1 | dContactMotion1;
  surface.mu = settings.treel_friction;
  surface.motion1 = robot.treels.rim_speed[solid.side];
  Eigen::Map<Eigen::Vector3d>(contact.fdir1) = ahead;
}

}  // namespace swarmanoid::dynamics3d
