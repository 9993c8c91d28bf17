#include "dynamics3d/mechanisms/arms.hpp"

#include <algorithm>
#include <cmath>

#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;

// The stops are a little beyond the range of the motors. A motor that holds its joint at the end of the range and a
// stop there would share the load in an undetermined way.
constexpr double kStopGap = 1e-3;  // rad

/// The rigid body that carries a joint.
dBodyID carrierOf(const Body& body, const std::vector<Link>& links, int joint) {
  const int carrier = body.model->joints[static_cast<std::size_t>(joint)].carrier;
  return carrier < 0 ? body.rigid : links[static_cast<std::size_t>(carrier)].rigid;
}

/// @pre the rigid bodies of the link and of its carrier have their poses with all joints at zero
void makeHinge(dWorldID world, const EntityModel::Joint& joint, dBodyID carrier, Link& link) {
  link.hinge = dJointCreateHinge(world, nullptr);
  dJointAttach(link.hinge, link.rigid, carrier);
  dJointSetHingeAnchor(link.hinge, joint.frame.position.x(), joint.frame.position.y(), joint.frame.position.z());
  dJointSetHingeAxis(link.hinge, joint.axis.x(), joint.axis.y(), joint.axis.z());
  dJointSetHingeParam(link.hinge, dParamFMax, joint.max_effort);
  dJointSetFeedback(link.hinge, &link.feedback);
}

/// Makes the stops as a joint of their own, since the hinge has a motor: at a stop ODE's hinges drive with the motor's
/// whole torque for a step, at any resulting speed, and beyond half a turn they confuse the two stops.
void makeStop(dWorldID world, const EntityModel::Joint& joint, dBodyID carrier, Link& link) {
  link.stop = dJointCreateAMotor(world, nullptr);
  dJointAttach(link.stop, link.rigid, carrier);
  dJointSetAMotorNumAxes(link.stop, 1);
  dJointSetAMotorAxis(link.stop, 0, 1, joint.axis.x(), joint.axis.y(), joint.axis.z());
  dJointSetAMotorParam(link.stop, dParamLoStop, joint.lower - kStopGap);
  dJointSetAMotorParam(link.stop, dParamHiStop, joint.upper + kStopGap);
  dJointSetFeedback(link.stop, &link.stop_feedback);
}

bool isEndless(const EntityModel::Joint& joint) { return std::isinf(joint.upper); }

/// Current angle of the joint. If it has stops, the angle continues beyond half a turn, where the hinge's angle wraps.
double turnedTo(const EntityModel::Joint& joint, const Link& link) {
  const double angle = dJointGetHingeAngle(link.hinge);
  return isEndless(joint) ? angle : link.angle + wrapAngle(angle - link.angle);
}

/// The commanded angle, limited to the joint's range, minus the joint's angle [rad].
double missingTo(const EntityModel::Joint& joint, const Link& link) {
  const double target = link.command.value;
  return isEndless(joint) ? wrapAngle(target - link.angle) : std::clamp(target, joint.lower, joint.upper) - link.angle;
}

}  // namespace

std::vector<Link> makeLinks(dWorldID world, const Body& body) {
  const std::vector<EntityModel::Joint>& joints = body.model->joints;
  SWARMANOID_EXPECTS(body.rigid != nullptr);
  std::vector<Link> links(joints.size());
  // hinges take the poses of their bodies at creation as their zero
  setBodyPose(body.rigid, body.own.centre_of_mass, Eigen::Quaterniond::Identity());
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const EntityModel::Joint& joint = joints[i];
    Link& link = links[i];
    link.rigid = dBodyCreate(world);
    const Vector3d& at = joint.part.centre_of_mass;
    dBodySetPosition(link.rigid, at.x(), at.y(), at.z());
    const dBodyID carrier = carrierOf(body, links, static_cast<int>(i));
    makeHinge(world, joint, carrier, link);
    makeStop(world, joint, carrier, link);
  }
  return links;
}

void placeLinks(Body& body, Span<const JointState> joints) {
  for (std::size_t i = 0; i < body.links.size(); ++i) {
    body.links[i].angle = joints.empty() ? 0.0 : joints[i].angle;
    const Eigen::Isometry3d displacement = displacementOf(*body.model, joints, static_cast<int>(i));
    const Vector3d& centre = body.model->joints[i].part.centre_of_mass;
    const Eigen::Quaterniond turn = body.pose.orientation * Eigen::Quaterniond(displacement.linear());
    setBodyPose(body.links[i].rigid, body.pose.toWorld(displacement * centre), turn.normalized());
  }
}

void moveLinks(Body& body, const Twist& twist, Span<const JointState> joints) {
  for (std::size_t i = 0; i < body.links.size(); ++i) {
    const EntityModel::Joint& joint = body.model->joints[i];
    const Eigen::Isometry3d displacement = displacementOf(*body.model, joints, static_cast<int>(i));
    const auto inWorld = [&](const Vector3d& point) -> Vector3d { return body.pose.toWorld(displacement * point); };
    // the carrier moves the joint, and the joint the link
    Vector3d carrier_turning = twist.angular;
    Vector3d carrier_speed = twist.linear;
    Vector3d carrier_place = body.pose.position;
    if (joint.carrier >= 0) {
      const auto c = static_cast<std::size_t>(joint.carrier);
      carrier_turning = toVector(dBodyGetAngularVel(body.links[c].rigid));
      carrier_speed = toVector(dBodyGetLinearVel(body.links[c].rigid));
      carrier_place = toVector(dBodyGetPosition(body.links[c].rigid));
    }
    const Vector3d axis = body.pose.orientation * (displacement.linear() * joint.axis);
    const Vector3d hinge = inWorld(joint.frame.position);
    const Vector3d turning = carrier_turning + (joints.empty() ? 0.0 : joints[i].speed) * axis;
    const Vector3d speed = carrier_speed + carrier_turning.cross(hinge - carrier_place) +
                           turning.cross(inWorld(joint.part.centre_of_mass) - hinge);
    dBodySetLinearVel(body.links[i].rigid, speed.x(), speed.y(), speed.z());
    dBodySetAngularVel(body.links[i].rigid, turning.x(), turning.y(), turning.z());
  }
}

void turnSolids(Body& body, Span<const JointState> joints) {
  for (std::size_t i = 0; i < body.model->shapes.size(); ++i) {
    if (body.model->shapes[i].joint < 0) {
      continue;
    }
    const CollisionShape shape = placeOf(*body.model, joints, body.model->shapes[i]);
    setGeomOffset(body.solids[i].geom, shape.position - body.own.centre_of_mass, shape.orientation);
  }
}

void driveLinks(Body& body) {
  constexpr double kGain = 20.0;  // 1/s: approach with a time constant of 0.05 s
  for (std::size_t i = 0; i < body.links.size(); ++i) {
    Link& link = body.links[i];
    const EntityModel::Joint& joint = body.model->joints[i];
    link.angle = turnedTo(joint, link);
    dJointSetAMotorAngle(link.stop, 0, link.angle);
    link.stop_feedback = {};  // ODE does not write the feedback of an idle stop
    const bool is_at_speed = link.command.mode == JointCommand::Mode::kSpeed;
    const double speed = is_at_speed ? link.command.value : kGain * missingTo(joint, link);
    const bool is_off = link.command.mode == JointCommand::Mode::kPassive;
    dJointSetHingeParam(link.hinge, dParamFMax, is_off ? 0.0 : joint.max_effort);
    dJointSetHingeParam(link.hinge, dParamVel, std::clamp(speed, -joint.max_speed, joint.max_speed));
  }
}

void readLinks(const Body& body, Span<JointState> joints) {
  for (std::size_t i = 0; i < body.links.size(); ++i) {
    const Link& link = body.links[i];
    dVector3 axis;
    dVector3 anchor;
    dJointGetHingeAxis(link.hinge, axis);
    dJointGetHingeAnchor(link.hinge, anchor);
    // ODE reports the torque about the link's centre; the hinge's own force has none about the axis
    const Vector3d arm = toVector(dBodyGetPosition(link.rigid)) - toVector(anchor);
    const Vector3d torque =
        toVector(link.feedback.t1) + toVector(link.stop_feedback.t1) + arm.cross(toVector(link.feedback.f1));
    joints[i].angle = turnedTo(body.model->joints[i], link);
    joints[i].speed = dJointGetHingeAngleRate(link.hinge);
    joints[i].effort = toVector(axis).dot(torque);
  }
}

}  // namespace swarmanoid::dynamics3d
