/// The turret of a robot in three dimensions.
///
/// What the gripper of a robot whose turret is commanded holds hangs on a hinge about body z through the robot's
/// origin, which the turret's motor turns with no more than its torque: a load that is too heavy to turn turns the
/// robot instead. While nothing is held the gripper's solids are turned as commanded, and stop before they would sink
/// into something.
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
  int joint = -1;        ///< of the model; -1: it has no turret, or that is a link
  JointState state;
  double angle_at_grip = 0.0;  ///< when the hinge was made [rad]

  bool isCommanded() const { return command.mode != JointCommand::Mode::kNone; }
};

/// Why the robot's gripper cannot be simulated with these devices; "" if it can, or is not used. A gripper turns with a
/// turret alone: one on a link that is a body of its own would grip where the link is not.
std::string unsupportedGripperReason(const EntityModel& model, const std::vector<DeviceUse>& devices);

/// Looks for the robot's turret, and for the command of its motor. If other joints are commanded too, the links of the
/// robot are bodies of their own, and the turret is one of these (arms.hpp).
void findTurret(Body& body, const Space& space);

/// The joint's state comes from the space, and the gripper's solids go where it says. @pre findTurret
void takeTurret(Body& body, const Space& space);

/// The gripper's tip in the frame B [m]. @pre it has a gripper
Eigen::Vector3d gripperTip(const Body& robot);

/// A hinge between a robot and what it grips, with the turret as its motor. @pre the turret is commanded
dJointID makeTurretHinge(dWorldID world, Body& robot, const Body& object);

/// Before a step [s]: sets the motor, or turns the gripper's solids.
void driveTurret(Body& robot, const Touches& touches, double step);
/// After it: what the hinge did.
void readTurret(Body& robot);

}  // namespace swarmanoid::dynamics3d
