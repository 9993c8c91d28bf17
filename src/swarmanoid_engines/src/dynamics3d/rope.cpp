#include "dynamics3d/rope.hpp"

#include <algorithm>

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;

constexpr double kWindingForce = 60.0;  // N: of the motor that winds in, twice a handbot's weight
constexpr double kShortest = 0.02;      // m

Vector3d anchorOf(const Rope& rope) {
  const Pose pose = rope.held->rigid == nullptr ? rope.held->pose : rope.held->currentPose();
  return pose.position + pose.orientation * rope.anchor;
}

Vector3d speedAt(dBodyID rigid, const Vector3d& point) {
  if (rigid == nullptr) {
    return Vector3d::Zero();
  }
  dVector3 speed;
  dBodyGetPointVel(rigid, point.x(), point.y(), point.z(), speed);
  return toVector(speed);
}

}  // namespace

Vector3d launcherOf(const Body& robot) {
  const Pose pose = robot.currentPose();
  return pose.position + pose.orientation * robot.model->mount("rope_launcher").position;
}

void windRope(Holding& holding, double step) {
  Rope& rope = holding.rope;
  double wanted = holding.rope_command == nullptr ? 0.0 : holding.rope_command->winding_speed;
  if (wanted > 0.0 && rope.tension > kWindingForce) {
    wanted = 0.0;
  }
  rope.winding = std::clamp(wanted, (rope.length - kRopeLength) / step, (rope.length - kShortest) / step);
}

dJointID makeRopeJoint(dWorldID world, dJointGroupID joints, Body& robot, double step) {
  Rope& rope = robot.holding->rope;
  const Vector3d launcher = launcherOf(robot);
  const Vector3d anchor = anchorOf(rope);
  const Vector3d way = anchor - launcher;
  const double excess = way.norm() - rope.length;
  // the direction of the middle of the step: that of its start would let a pendulum lose its swing
  const Vector3d approach = speedAt(robot.rigid, launcher) - speedAt(rope.held->rigid, anchor);
  rope.towards = (way - 0.5 * step * approach).normalized();

  dContact contact = {};
  contact.surface.mode = dContactApprox1 | dContactMotionN;
  contact.geom.depth = std::max(excess, 0.0);
  contact.surface.motionN = rope.winding + std::min(excess, 0.0) / step;
  Eigen::Map<Vector3d>(contact.geom.normal) = rope.towards;
  Eigen::Map<Vector3d>(contact.geom.pos) = launcher;
  const dJointID joint = dJointCreateContact(world, joints, &contact);
  dJointAttach(joint, robot.rigid, rope.held->rigid);
  rope.feedback = {};
  dJointSetFeedback(joint, &rope.feedback);
  return joint;
}

void feelRope(Rope& rope, double step, double share, double strength) {
  rope.length -= step * rope.winding;
  rope.tension += share * (toVector(rope.feedback.f1).dot(rope.towards) - rope.tension);
  if (rope.tension > strength) {
    rope.is_broken = true;
  }
}

}  // namespace swarmanoid::dynamics3d
