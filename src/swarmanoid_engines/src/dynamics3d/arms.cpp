#include "dynamics3d/arms.hpp"

#include <algorithm>

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;

const double* targetOf(const std::string& joint, const HandbotArms& arms) {
  const std::array<const double*, HandbotArmsState::kJoints> angles{&arms.left.shoulder, &arms.left.elbow,
                                                                    &arms.left.wrist,    &arms.right.shoulder,
                                                                    &arms.right.elbow,   &arms.right.wrist};
  for (std::size_t i = 0; i < angles.size(); ++i) {
    if (joint == HandbotArmsState::kNames[i]) {
      return angles[i];
    }
  }
  return nullptr;
}

/// The rigid body that carries a joint.
dBodyID carrierOf(const Body& body, const std::vector<Link>& links, int joint) {
  const int carrier = body.model->joints[static_cast<std::size_t>(joint)].carrier;
  return carrier < 0 ? body.rigid : links[static_cast<std::size_t>(carrier)].rigid;
}

}  // namespace

std::vector<Link> makeLinks(dWorldID world, const Body& body, const HandbotArms& arms) {
  const std::vector<EntityModel::Joint>& joints = body.model->joints;
  std::vector<Link> links(joints.size());
  // hinges remember how their bodies are when they are made as their zero
  setBodyPose(body.rigid, body.own.centre_of_mass, Eigen::Quaterniond::Identity());
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const EntityModel::Joint& joint = joints[i];
    Link& link = links[i];
    link.target = targetOf(joint.name, arms);
    link.rigid = dBodyCreate(world);
    const Vector3d& at = joint.part.centre_of_mass;
    dBodySetPosition(link.rigid, at.x(), at.y(), at.z());
    link.hinge = dJointCreateHinge(world, nullptr);
    dJointAttach(link.hinge, link.rigid, carrierOf(body, links, static_cast<int>(i)));
    dJointSetHingeAnchor(link.hinge, joint.frame.position.x(), joint.frame.position.y(), joint.frame.position.z());
    dJointSetHingeAxis(link.hinge, joint.axis.x(), joint.axis.y(), joint.axis.z());
    dJointSetHingeParam(link.hinge, dParamLoStop, std::max(joint.lower, -M_PI));
    dJointSetHingeParam(link.hinge, dParamHiStop, std::min(joint.upper, M_PI));
    dJointSetHingeParam(link.hinge, dParamFMax, joint.max_effort);
    dJointSetFeedback(link.hinge, &link.feedback);
  }
  return links;
}

void placeLinks(Body& body, const JointState* joints) {
  const JointState zero[Space::kMaxJoints] = {};
  for (std::size_t i = 0; i < body.links.size(); ++i) {
    const Eigen::Isometry3d displacement =
        displacementOf(*body.model, joints == nullptr ? zero : joints, static_cast<int>(i));
    const Vector3d& centre = body.model->joints[i].part.centre_of_mass;
    const Eigen::Quaterniond turn = body.pose.orientation * Eigen::Quaterniond(displacement.linear());
    setBodyPose(body.links[i].rigid, body.pose.position + body.pose.orientation * (displacement * centre),
                turn.normalized());
  }
}

void moveLinks(Body& body, const Twist& twist, const JointState* joints) {
  const JointState zero[Space::kMaxJoints] = {};
  const JointState* states = joints == nullptr ? zero : joints;
  std::array<Vector3d, Space::kMaxJoints> turning;  // of the links, in W
  for (std::size_t i = 0; i < body.links.size(); ++i) {
    const EntityModel::Joint& joint = body.model->joints[i];
    const Eigen::Isometry3d displacement = displacementOf(*body.model, states, static_cast<int>(i));
    const auto inWorld = [&](const Vector3d& point) -> Vector3d {
      return body.pose.position + body.pose.orientation * (displacement * point);
    };
    // as the carrier moves the joint, and the joint the link
    Vector3d carrier_turning = twist.angular;
    Vector3d carrier_speed = twist.linear;
    Vector3d carrier_place = body.pose.position;
    if (joint.carrier >= 0) {
      const auto c = static_cast<std::size_t>(joint.carrier);
      carrier_turning = turning[c];
      carrier_speed = toVector(dBodyGetLinearVel(body.links[c].rigid));
      carrier_place = toVector(dBodyGetPosition(body.links[c].rigid));
    }
    const Vector3d axis = body.pose.orientation * (displacement.linear() * joint.axis);
    const Vector3d hinge = inWorld(joint.frame.position);
    turning[i] = carrier_turning + states[i].speed * axis;
    const Vector3d speed = carrier_speed + carrier_turning.cross(hinge - carrier_place) +
                           turning[i].cross(inWorld(joint.part.centre_of_mass) - hinge);
    dBodySetLinearVel(body.links[i].rigid, speed.x(), speed.y(), speed.z());
    dBodySetAngularVel(body.links[i].rigid, turning[i].x(), turning[i].y(), turning[i].z());
  }
}

void turnSolids(Body& body, const JointState* joints) {
  for (std::size_t i = 0; i < body.model->shapes.size(); ++i) {
    if (body.model->shapes[i].joint < 0) {
      continue;
    }
    const CollisionShape shape = placeOf(*body.model, joints, body.model->shapes[i]);
    setGeomOffset(body.solids[i].geom, shape.position - body.own.centre_of_mass, shape.orientation);
  }
}

void driveLinks(Body& body) {
  constexpr double kGain = 20.0;  // 1/s: the last of the way takes a twentieth of a second
  for (std::size_t i = 0; i < body.links.size(); ++i) {
    const Link& link = body.links[i];
    const double most = body.model->joints[i].max_speed;
    const double missing = (link.target == nullptr ? 0.0 : *link.target) - dJointGetHingeAngle(link.hinge);
    dJointSetHingeParam(link.hinge, dParamVel, std::clamp(kGain * missing, -most, most));
  }
}

void readLinks(const Body& body, JointState* joints) {
  for (std::size_t i = 0; i < body.links.size(); ++i) {
    const Link& link = body.links[i];
    dVector3 axis;
    dVector3 anchor;
    dJointGetHingeAxis(link.hinge, axis);
    dJointGetHingeAnchor(link.hinge, anchor);
    // ODE tells the torque about the link's centre; about the axis the hinge's own force has none
    const Vector3d arm = toVector(dBodyGetPosition(link.rigid)) - toVector(anchor);
    const Vector3d torque = toVector(link.feedback.t1) + arm.cross(toVector(link.feedback.f1));
    joints[i].angle = dJointGetHingeAngle(link.hinge);
    joints[i].speed = dJointGetHingeAngleRate(link.hinge);
    joints[i].effort = toVector(axis).dot(torque);
  }
}

}  // namespace swarmanoid::dynamics3d
