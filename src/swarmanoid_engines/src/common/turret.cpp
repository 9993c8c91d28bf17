#include "common/turret.hpp"

#include <algorithm>
#include <cmath>

#include "swarmanoid_interface/angle.hpp"

namespace swarmanoid {

int turretJoint(const EntityModel& model) {
  constexpr double kStraight = 1e-9;
  const int index = model.findJoint("turret");
  if (index < 0) {
    return -1;
  }
  const EntityModel::Joint& joint = model.joints[static_cast<std::size_t>(index)];
  const bool is_around_body = joint.carrier < 0 && joint.frame.position.head<2>().norm() < kStraight &&
                              (joint.axis - Eigen::Vector3d::UnitZ()).norm() < kStraight;
  return is_around_body && std::isinf(joint.lower) && std::isinf(joint.upper) ? index : -1;
}

double freeTurn(const FootbotTurret& command, const EntityModel::Joint& joint, double angle, double step) {
  const double most = joint.max_speed * step;
  if (command.mode == FootbotTurret::Mode::kAngle) {
    const double left = wrapTurn(command.angle - angle);
    return std::abs(left) <= most ? wrapTurn(command.angle) : wrapTurn(angle + std::copysign(most, left));
  }
  if (command.mode == FootbotTurret::Mode::kSpeed) {
    return wrapTurn(angle + std::clamp(command.speed * step, -most, most));
  }
  return angle;
}

double motorSpeed(const FootbotTurret& command, const EntityModel::Joint& joint, double angle, double step) {
  // a motor that can only just move its load would swing around an angle that it hurries to
  constexpr double kApproach = 0.1;  // s
  double speed = 0.0;
  if (command.mode == FootbotTurret::Mode::kAngle) {
    speed = wrapTurn(command.angle - angle) / std::max(kApproach, step);
  } else if (command.mode == FootbotTurret::Mode::kSpeed) {
    speed = command.speed;
  }
  return std::clamp(speed, -joint.max_speed, joint.max_speed);
}

}  // namespace swarmanoid
