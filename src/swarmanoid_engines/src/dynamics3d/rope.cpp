#include "dynamics3d/rope.hpp"

#include <algorithm>
#include <cmath>

#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;

constexpr double kWindingForce = 60.0;  // N: of the motor that winds in, twice a handbot's weight
constexpr double kShortest = 0.02;      // m

Vector3d anchorOf(const Rope& rope) {
  const Pose pose = rope.held->rigid == nullptr ? rope.held->pose : rope.held->currentPose();
  return pose.toWorld(rope.anchor);
}

/// How fast a point of a body goes after a step if nothing but gravity acts on it.
Vector3d speedAfter(dWorldID world, dBodyID rigid, const Vector3d& point, double step) {
  dVector3 gravity = {};
  if (rigid != nullptr && dBodyIsKinematic(rigid) == 0) {
    dWorldGetGravity(world, gravity);
  }
  return velocityAt(rigid, point) + step * toVector(gravity);
}

}  // namespace

Vector3d launcherOf(const Body& robot) {
  const Pose pose = robot.currentPose();
  return pose.toWorld(robot.model->mount("rope_launcher").position);
}

void windRope(Holding& holding, double step) {
  SWARMANOID_EXPECTS(holding.rope.held != nullptr);
  Rope& rope = holding.rope;
  double wanted = holding.rope_command == nullptr ? 0.0 : holding.rope_command->winding_speed;
  if (wanted > 0.0 && rope.tension > kWindingForce) {
    wanted = 0.0;
  }
  rope.winding = std::clamp(wanted, (rope.length - kRopeLength) / step, (rope.length - kShortest) / step);
}

void dragRope(Body& robot, double drag) {
  SWARMANOID_EXPECTS(robot.holding->rope.held != nullptr);
  const Rope& rope = robot.holding->rope;
  const bool is_slack = toVector(rope.feedback.f1).isZero(0.0);
  if (drag == 0.0 || is_slack) {
    return;
  }
  const Vector3d launcher = launcherOf(robot);
  const Vector3d speed = velocityAt(robot.rigid, launcher);
  const Vector3d force = -drag * (speed - rope.towards.dot(speed) * rope.towards);
  dBodyAddForceAtPos(robot.rigid, force.x(), force.y(), force.z(), launcher.x(), launcher.y(), launcher.z());
}

dJointID makeRopeJoint(dWorldID world, dJointGroupID joints, Body& robot, double step) {
  SWARMANOID_EXPECTS(robot.holding->rope.held != nullptr);
  Rope& rope = robot.holding->rope;
  const Vector3d launcher = launcherOf(robot);
  const Vector3d anchor = anchorOf(rope);
  const Vector3d way = anchor - launcher;
  const double distance = way.norm();
  rope.towards = way.normalized();

  // It pulls along its direction at the start of the step, so much that its ends are its length apart at the end. Who
  // swings moves across it meanwhile, which takes them apart; the speed that the last step left would pull too late.
  const Vector3d speed =
      speedAfter(world, robot.rigid, launcher, step) - speedAfter(world, rope.held->rigid, anchor, step);
  const double across = step * (speed - rope.towards.dot(speed) * rope.towards).norm();
  const double length = rope.length - step * rope.winding;
  const double along = std::sqrt(std::max(length * length - across * across, 0.0));

  dContact contact = {};
  contact.surface.mode = dContactApprox1 | dContactMotionN;
  contact.surface.motionN = (distance - along) / step;
  Eigen::Map<Vector3d>(contact.geom.normal) = rope.towards;
  Eigen::Map<Vector3d>(contact.geom.pos) = launcher;
  const dJointID joint = dJointCreateContact(world, joints, &contact);
  dJointAttach(joint, robot.rigid, rope.held->rigid);
  rope.feedback = {};
  dJointSetFeedback(joint, &rope.feedback);
  return joint;
}

void feelRope(Rope& rope, double step, double share, double strength) {
  SWARMANOID_EXPECTS(rope.held != nullptr);
  rope.length -= step * rope.winding;
  rope.tension += share * (toVector(rope.feedback.f1).dot(rope.towards) - rope.tension);
  if (rope.tension > strength) {
    rope.is_broken = true;
  }
}

}  // namespace swarmanoid::dynamics3d
