#include "dynamics3d/mechanisms/hanging.hpp"

#include <algorithm>

#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;

Eigen::Matrix3d axesOf(dBodyID rigid) { return toQuaternion(dBodyGetQuaternion(rigid)).toRotationMatrix(); }

/// Adds the gyroscopic torque in place of ODE's.
void startTurning(dBodyID rigid, const Eigen::Matrix3d& inertia, Turning& turning) {
  const Eigen::Matrix3d axes = axesOf(rigid);
  turning.before = axes.transpose() * toVector(dBodyGetAngularVel(rigid));
  const Vector3d middle = turning.before + 0.5 * turning.change;
  const Vector3d torque = axes * (inertia * middle).cross(middle);
  dBodySetGyroscopicMode(rigid, 0);
  dBodyAddTorque(rigid, torque.x(), torque.y(), torque.z());
}

void finishTurning(dBodyID rigid, Turning& turning) {
  // the new angular velocity is the same in the frame at the start of the step: the body has turned about it
  turning.change = axesOf(rigid).transpose() * toVector(dBodyGetAngularVel(rigid)) - turning.before;
  dBodySetGyroscopicMode(rigid, 1);
}

void displace(dBodyID rigid, const Vector3d& way) {
  const Vector3d place = toVector(dBodyGetPosition(rigid)) + way;
  dBodySetPosition(rigid, place.x(), place.y(), place.z());
}

bool isTaut(const Rope& rope) {
  return rope.held != nullptr && !rope.is_broken && !toVector(rope.feedback.f1).isZero(0.0);
}

}  // namespace

void prepareHanging(Body& robot, double error_reduction) {
  SWARMANOID_EXPECTS(robot.holding != nullptr && error_reduction > 0.0);
  Holding& holding = *robot.holding;
  holding.hangs = robot.is_dynamic && std::any_of(holding.ropes.begin(), holding.ropes.end(), isTaut);
  if (!holding.hangs) {
    holding.turning = {};
    for (Link& link : robot.links) {
      link.turning = {};
      link.opening.setZero();
    }
    return;
  }
  startTurning(robot.rigid, robot.own.inertia, holding.turning);
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    Link& link = robot.links[i];
    const EntityModel::Joint& joint = robot.model->joints[i];
    startTurning(link.rigid, joint.part.inertia, link.turning);
    link.displaced = axesOf(link.rigid) * link.opening / error_reduction;
    if (joint.carrier >= 0) {
      link.displaced += robot.links[static_cast<std::size_t>(joint.carrier)].displaced;
    }
    displace(link.rigid, link.displaced);
  }
}

void finishHanging(Body& robot) {
  if (!robot.holding->hangs) {
    return;
  }
  finishTurning(robot.rigid, robot.holding->turning);
  for (Link& link : robot.links) {
    finishTurning(link.rigid, link.turning);
    displace(link.rigid, -link.displaced);
  }
}

bool areHingesKept(Body& robot) {
  constexpr double kPrecision = 2e-6;  // m
  constexpr double kMost = 1e-3;       // m: wider gaps come from impacts
  if (robot.holding == nullptr || !robot.holding->hangs) {
    return true;
  }
  bool are_kept = true;
  for (Link& link : robot.links) {
    dVector3 on_link;
    dVector3 on_carrier;
    dJointGetHingeAnchor(link.hinge, on_link);
    dJointGetHingeAnchor2(link.hinge, on_carrier);
    const Vector3d gap = toVector(on_link) - toVector(on_carrier);
    if (gap.norm() > kPrecision) {
      link.opening += axesOf(link.rigid).transpose() * gap;
      link.opening *= std::min(1.0, kMost / link.opening.norm());
      are_kept = false;
    }
  }
  return are_kept;
}

}  // namespace swarmanoid::dynamics3d
