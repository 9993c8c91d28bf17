/// Shared by engines that simulate turrets, joints that turn a gripper around a robot: which joint is the turret, and
/// the speed of its motor.
#pragma once

#include "swarmanoid_space/state/joints.hpp"
#include "swarmanoid_space/state/mechanisms.hpp"

namespace swarmanoid {

/// The joint that is the turret of a robot: the first joint on the body that turns endlessly about body z.
/// @return its index; -1 if there is none
int turretJoint(const EntityModel& model);

/// Angle of an unobstructed turret after a step [s]; a passive turret stays.
double freeTurn(const JointCommand& command, const EntityModel::Joint& joint, double angle, double step);

/// Speed of a turret's motor under load during a step [s], if its torque suffices [rad/s].
double motorSpeed(const JointCommand& command, const EntityModel::Joint& joint, double angle, double step);

}  // namespace swarmanoid
