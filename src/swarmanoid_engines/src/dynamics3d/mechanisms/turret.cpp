#include "dynamics3d/mechanisms/turret.hpp"

#include <algorithm>
#include <cmath>

#include "common/unsupported_mechanisms.hpp"
#include "dynamics3d/body.hpp"
#include "dynamics3d/contacts/touches.hpp"
#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid::dynamics3d {
namespace {

const EntityModel::Joint& jointOf(const Body& robot) {
  return robot.model->joints[static_cast<std::size_t>(robot.turret.joint)];
}

/// The hinge of the gripped body; null if there is none.
dJointID hingeOf(const Body& robot) {
  const dJointID joint = robot.grip.joint;
  return joint != nullptr && dJointGetType(joint) == dJointTypeHinge ? joint : nullptr;
}

/// Calls visit(solid) for the solids that the turret turns. Those of the model's shapes come first, in their order.
template <class Visit>
void visitTurned(const Body& robot, Visit visit) {
  for (std::size_t i = 0; i < robot.model->shapes.size(); ++i) {
    if (robot.model->shapes[i].joint == robot.turret.joint) {
      visit(robot.solids[i], robot.model->shapes[i]);
    }
  }
}

void turnSolids(const Body& robot, double angle) {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()));
  visitTurned(robot, [&](const Solid& solid, const CollisionShape& shape) {
    Eigen::Vector3d offset = turn * shape.position - robot.model->centre_of_mass;
    offset.z() = dGeomGetOffsetPosition(solid.geom)[2];  // shapes near the ground have been cut
    setGeomOffset(solid.geom, offset, turn * shape.orientation);
  });
}

/// Depth of the turned solids in other bodies [m].
double depthOf(const Body& robot, const Touches& touches) {
  double deepest = 0.0;
  visitTurned(robot, [&](const Solid& solid, const CollisionShape&) {
    deepest = std::max(deepest, touches.depthAmongBodies(robot, solid));
  });
  return deepest;
}

void turnFreely(Body& robot, const Touches& touches, double step) {
  JointState& state = robot.turret.state;
  const double angle = freeTurn(robot.turret.command, jointOf(robot), state.angle, step);
  state.speed = 0.0;
  state.effort = 0.0;
  if (angle == state.angle) {
    return;
  }
  const double depth = depthOf(robot, touches);
  turnSolids(robot, angle);
  const double new_depth = depthOf(robot, touches);
  if (new_depth > 0.0 && new_depth > depth) {
    turnSolids(robot, state.angle);
    return;
  }
  state.speed = wrapTurn(angle - state.angle) / step;
  state.angle = angle;
}

/// Whether the device commands a joint that is no turret.
bool commandsLinks(const EntityModel& model, const DeviceUse& device) {
  const int turret = turretJoint(model);
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    if (static_cast<int>(i) != turret && device.kind == DeviceKind::kActuator &&
        worksWith(device, Mechanism::Kind::kJoint, model.joints[i].name)) {
      return true;
    }
  }
  return false;
}

/// Whether the device closes a gripper that a joint turns.
bool usesTurnedGripper(const EntityModel& model, const DeviceUse& device) {
  return device.kind == DeviceKind::kActuator &&
         std::any_of(model.holders.begin(), model.holders.end(), [&](const EntityModel::Holder& holder) {
           const auto mount = model.mounts.find(holder.mount);
           const bool is_turned = mount != model.mounts.end() && mount->second.joint >= 0;
           return holder.kind == EntityModel::Holder::Kind::kGripper && is_turned &&
                  worksWith(device, Mechanism::Kind::kHolder, holder.name);
         });
}

}  // namespace

std::string unsupportedGripperReason(const EntityModel& model, const std::vector<DeviceUse>& devices) {
  const auto user = std::find_if(devices.begin(), devices.end(),
                                 [&](const DeviceUse& device) { return usesTurnedGripper(model, device); });
  const bool has_links = std::any_of(devices.begin(), devices.end(),
                                     [&](const DeviceUse& device) { return commandsLinks(model, device); });
  return user == devices.end() || !has_links
             ? ""
             : "device '" + user->type +
                   "' cannot be simulated: the gripper is on a link, and joints besides a turret are commanded";
}

void findTurret(Body& body, const Space& space) {
  Turret& turret = body.turret;
  turret.joint = body.links.empty() ? turretJoint(*body.model) : -1;
  if (turret.joint >= 0 && body.is_dynamic) {
    turret.command = space.joint_commands[body.row][static_cast<std::size_t>(turret.joint)];
  }
}

void takeTurret(Body& body, const Space& space) {
  Turret& turret = body.turret;
  if (turret.joint < 0 || body.rigid == nullptr) {
    return;
  }
  const double before = turret.state.angle;
  turret.state = space.joints[body.row][turret.joint];
  if (turret.state.angle != before) {
    turnSolids(body, turret.state.angle);
  }
}

Eigen::Vector3d gripperTip(const Body& robot) {
  SWARMANOID_EXPECTS(robot.model->gripper.has_value());
  const EntityModel::Gripper& gripper = *robot.model->gripper;
  const Eigen::Vector3d tip(gripper.tip, 0.0, gripper.height);
  const double angle = robot.turret.state.angle;
  return angle == 0.0 ? tip : Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()) * tip;
}

dJointID makeTurretHinge(dWorldID world, Body& robot, const Body& object) {
  SWARMANOID_EXPECTS(robot.turret.isCommanded());
  const Pose pose = robot.currentPose();
  // ODE's hinges measure angle and rate of the first body relative to the second
  const Eigen::Vector3d down = pose.orientation * -Eigen::Vector3d::UnitZ();
  const dJointID hinge = dJointCreateHinge(world, nullptr);
  dJointAttach(hinge, robot.rigid, object.rigid);
  dJointSetHingeAnchor(hinge, pose.position.x(), pose.position.y(), pose.position.z());
  dJointSetHingeAxis(hinge, down.x(), down.y(), down.z());
  robot.turret.angle_at_grip = robot.turret.state.angle;
  return hinge;
}

void driveTurret(Body& robot, const Touches& touches, double step) {
  if (!robot.turret.isCommanded()) {
    return;
  }
  const dJointID hinge = hingeOf(robot);
  if (hinge == nullptr) {
    turnFreely(robot, touches, step);
    return;
  }
  const JointCommand& command = robot.turret.command;
  const EntityModel::Joint& joint = jointOf(robot);
  const bool is_off = command.mode == JointCommand::Mode::kPassive;
  dJointSetHingeParam(hinge, dParamFMax, is_off ? 0.0 : joint.max_effort);
  dJointSetHingeParam(hinge, dParamVel, motorSpeed(command, joint, robot.turret.state.angle, step));
}

void readTurret(Body& robot) {
  const dJointID hinge = !robot.turret.isCommanded() ? nullptr : hingeOf(robot);
  if (hinge == nullptr) {
    return;
  }
  JointState& state = robot.turret.state;
  state.angle = wrapTurn(robot.turret.angle_at_grip + dJointGetHingeAngle(hinge));
  state.speed = dJointGetHingeAngleRate(hinge);
  const Eigen::Quaterniond turn = toQuaternion(dBodyGetQuaternion(robot.rigid));
  const Eigen::Vector3d arm = turn * -robot.model->centre_of_mass;  // from the centre of mass to the hinge
  const dJointFeedback& feedback = robot.grip.feedback;
  const Eigen::Vector3d on_robot = toVector(feedback.t1) - arm.cross(toVector(feedback.f1));
  state.effort = -(turn * Eigen::Vector3d::UnitZ()).dot(on_robot);
  turnSolids(robot, state.angle);
}

}  // namespace swarmanoid::dynamics3d
