/// What engines have in common that simulate turrets, joints that turn a gripper around a robot: which joint it is, and
/// the speed of its motor.
#pragma once

#include "swarmanoid_space/state/joints.hpp"
#include "swarmanoid_space/state/mechanisms.hpp"

namespace swarmanoid {

/// The joint that is the turret of a robot: the first that the body carries and that turns without end about body z.
/// @return its index; -1: there is none
int turretJoint(const EntityModel& model);

/// Where a turret that nothing hinders stands after a step [s]; a passive one stays.
double freeTurn(const JointCommand& command, const EntityModel::Joint& joint, double angle, double step);

/// The speed at which the motor of a turret that holds something turns for a step [s], if its torque suffices
/// [rad/s].
double motorSpeed(const JointCommand& command, const EntityModel::Joint& joint, double angle, double step);

}  // namespace swarmanoid
