#include "dynamics3d/mechanisms/rope.hpp"

#include <algorithm>
#include <cmath>

#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;

constexpr double kWindingForce = 60.0;  // N: of the winding motor, twice the weight of a climbing robot
constexpr double kShortest = 0.02;      // m

Vector3d anchorOf(const Rope& rope) {
  const Pose pose = rope.held->rigid == nullptr ? rope.held->pose : rope.held->currentPose();
  return pose.toWorld(rope.anchor);
}

/// Velocity of a point of a body after a step in which only gravity acts on it.
Vector3d speedAfter(dWorldID world, dBodyID rigid, const Vector3d& point, double step) {
  dVector3 gravity = {};
  if (rigid != nullptr && dBodyIsKinematic(rigid) == 0) {
    dWorldGetGravity(world, gravity);
  }
  return velocityAt(rigid, point) + step * toVector(gravity);
}

}  // namespace

Vector3d launcherOf(const Body& robot, std::size_t rope) {
  const Pose pose = robot.currentPose();
  return pose.toWorld(robot.model->mount(robot.holder(rope).mount).position);
}

void windRope(Body& robot, std::size_t index, double step) {
  Rope& rope = robot.holding->ropes[index];
  SWARMANOID_EXPECTS(rope.held != nullptr);
  double wanted = rope.wanted_winding;
  if (wanted > 0.0 && rope.tension > kWindingForce) {
    wanted = 0.0;
  }
  rope.winding =
      std::clamp(wanted, (rope.length - robot.holder(index).rope_length) / step, (rope.length - kShortest) / step);
}

void dragRope(Body& robot, std::size_t index, double drag) {
  const Rope& rope = robot.holding->ropes[index];
  SWARMANOID_EXPECTS(rope.held != nullptr);
  const bool is_slack = toVector(rope.feedback.f1).isZero(0.0);
  if (drag == 0.0 || is_slack) {
    return;
  }
  const Vector3d launcher = launcherOf(robot, index);
  const Vector3d speed = velocityAt(robot.rigid, launcher);
  const Vector3d force = -drag * (speed - rope.towards.dot(speed) * rope.towards);
  dBodyAddForceAtPos(robot.rigid, force.x(), force.y(), force.z(), launcher.x(), launcher.y(), launcher.z());
}

dJointID makeRopeJoint(dWorldID world, dJointGroupID joints, Body& robot, std::size_t index, double step) {
  Rope& rope = robot.holding->ropes[index];
  SWARMANOID_EXPECTS(rope.held != nullptr);
  const Vector3d launcher = launcherOf(robot, index);
  const Vector3d anchor = anchorOf(rope);
  const Vector3d way = anchor - launcher;
  const double distance = way.norm();
  rope.towards = way.normalized();

  // The rope pulls along its direction at the start of the step, so that its ends are its length apart at the end.
  // Meanwhile a swing moves the ends across the rope, which takes them apart; a pull by the speed that the last step
  // left would come too late. The correction covers the rest: the launcher moves along an arc about the centre of mass,
  // and the tension turns the body.
  const Vector3d speed =
      speedAfter(world, robot.rigid, launcher, step) - speedAfter(world, rope.held->rigid, anchor, step);
  const double across = step * (speed - rope.towards.dot(speed) * rope.towards).norm();
  const double length = rope.length - step * rope.winding;
  const double along = std::sqrt(std::max(length * length - across * across, 0.0));

  dContact contact = {};
  contact.surface.mode = dContactApprox1 | dContactMotionN;
  contact.surface.motionN = (distance - along) / step + rope.correction;
  Eigen::Map<Vector3d>(contact.geom.normal) = rope.towards;
  Eigen::Map<Vector3d>(contact.geom.pos) = launcher;
  const dJointID joint = dJointCreateContact(world, joints, &contact);
  dJointAttach(joint, robot.rigid, rope.held->rigid);
  rope.feedback = {};
  dJointSetFeedback(joint, &rope.feedback);
  return joint;
}

bool isRopeKept(Body& robot, std::size_t index, double step) {
  constexpr double kPrecision = 1e-6;  // m
  constexpr double kMost = 0.2;        // m/s: a launcher on an arm of 0.2 m that turns at 14 rad/s
  Rope& rope = robot.holding->ropes[index];
  SWARMANOID_EXPECTS(rope.held != nullptr);
  const double excess = (anchorOf(rope) - launcherOf(robot, index)).norm() - (rope.length - step * rope.winding);
  const bool is_slack = toVector(rope.feedback.f1).isZero(0.0);
  if (is_slack && excess < kPrecision) {
    rope.correction = 0.0;
    return true;
  }
  if (std::abs(excess) < kPrecision) {
    return true;
  }
  const double before = rope.correction;
  rope.correction = std::clamp(before + excess / step, -kMost, kMost);
  return rope.correction == before;
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
