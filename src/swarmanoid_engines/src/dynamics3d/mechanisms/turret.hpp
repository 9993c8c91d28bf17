/// The turret of a robot in three dimensions.
///
/// If a robot's turret is commanded, the gripped body hangs on a hinge about body z through the robot's origin. The
/// turret's motor turns the hinge with no more than its torque: a load that is too heavy to turn turns the robot
/// instead. Without a load, the gripper's solids turn as commanded, and stop before they would penetrate a body.
#pragma once

#include <string>
#include <vector>

#include "common/turret.hpp"
#include "dynamics3d/ode.hpp"
#include "swarmanoid_space/engine.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid::dynamics3d {

struct Body;
class Touches;

struct Turret {
  JointCommand command;  ///< of this tick
  int joint = -1;        ///< of the model; -1: it has no turret, or the turret is a link
  JointState state;
  double angle_at_grip = 0.0;  ///< when the hinge was made [rad]

  bool isCommanded() const { return command.mode != JointCommand::Mode::kNone; }
};

/// Reason why the robot's gripper cannot be simulated with these devices; "" if it can, or is not used. A gripper turns
/// only with a turret: on a link with a rigid body of its own, the gripping place would not follow the link.
std::string unsupportedGripperReason(const EntityModel& model, const std::vector<DeviceUse>& devices);

/// Finds the robot's turret, and the command of its motor. If other joints are commanded too, the links of the robot
/// are rigid bodies of their own, and the turret is one of these (arms.hpp).
void findTurret(Body& body, const Space& space);

/// Copies the joint's state from the space, and turns the gripper's solids to its angle. @pre findTurret
void takeTurret(Body& body, const Space& space);

/// The gripper's tip in the frame B [m]. @pre it has a gripper
Eigen::Vector3d gripperTip(const Body& robot);

/// A hinge between a robot and the body it grips, with the turret as its motor. @pre the turret is commanded
dJointID makeTurretHinge(dWorldID world, Body& robot, const Body& object);

/// Call before a step [s]: sets the motor, or turns the gripper's solids.
void driveTurret(Body& robot, const Touches& touches, double step);
/// Call after a step: reads the state of the hinge.
void readTurret(Body& robot);

}  // namespace swarmanoid::dynamics3d
