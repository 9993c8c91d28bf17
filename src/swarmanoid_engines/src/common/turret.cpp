#include "common/turret.hpp"

#include <algorithm>
#include <cmath>

#include "swarmanoid_interface/angle.hpp"

namespace swarmanoid {

int turretJoint(const EntityModel& model) {
  constexpr double kStraight = 1e-9;
  const auto is_turret = [](const EntityModel::Joint& joint) {
    const bool is_around_body = joint.carrier < 0 && joint.frame.position.head<2>().norm() < kStraight &&
                                (joint.axis - Eigen::Vector3d::UnitZ()).norm() < kStraight;
    return is_around_body && std::isinf(joint.lower) && std::isinf(joint.upper);
  };
  const auto found = std::find_if(model.joints.begin(), model.joints.end(), is_turret);
  return found == model.joints.end() ? -1 : static_cast<int>(found - model.joints.begin());
}

double freeTurn(const JointCommand& command, const EntityModel::Joint& joint, double angle, double step) {
  const double most = joint.max_speed * step;
  if (command.mode == JointCommand::Mode::kAngle) {
    const double left = wrapTurn(command.value - angle);
    return std::abs(left) <= most ? wrapTurn(command.value) : wrapTurn(angle + std::copysign(most, left));
  }
  if (command.mode == JointCommand::Mode::kSpeed) {
    return wrapTurn(angle + std::clamp(command.value * step, -most, most));
  }
  return angle;
}

double motorSpeed(const JointCommand& command, const EntityModel::Joint& joint, double angle, double step) {
  // without this, a motor that can barely move its load would oscillate around its target angle
  constexpr double kApproach = 0.1;  // s
  double speed = 0.0;
  if (command.mode == JointCommand::Mode::kAngle) {
    speed = wrapTurn(command.value - angle) / std::max(kApproach, step);
  } else if (command.mode == JointCommand::Mode::kSpeed) {
    speed = command.value;
  }
  return std::clamp(speed, -joint.max_speed, joint.max_speed);
}

}  // namespace swarmanoid
