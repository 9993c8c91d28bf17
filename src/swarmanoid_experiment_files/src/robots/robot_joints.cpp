#include "robot_joints.hpp"

#include <limits>

namespace swarmanoid {

bool isTurningJoint(const urdf::Joint& joint) {
  return joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::CONTINUOUS;
}

EntityModel::Joint readJoint(const UrdfFile& urdf, const urdf::Joint& joint, const Mount& frame, int carrier) {
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  if (joint.limits == nullptr || !(joint.limits->velocity > 0.0) || !(joint.limits->effort > 0.0)) {
    urdf.fail("joint '" + joint.name + "': expected limits of its velocity and its effort, both above 0");
  }
  const bool is_endless = joint.type == urdf::Joint::CONTINUOUS;
  EntityModel::Joint result;
  result.name = joint.name;
  result.link = joint.child_link_name;
  result.carrier = carrier;
  result.frame = frame;
  result.axis = frame.orientation * toAxis(Eigen::Vector3d(joint.axis.x, joint.axis.y, joint.axis.z));
  result.lower = is_endless ? -kEndless : joint.limits->lower;
  result.upper = is_endless ? kEndless : joint.limits->upper;
  result.max_speed = joint.limits->velocity;
  result.max_effort = joint.limits->effort;
  if (!(result.lower <= 0.0 && result.upper >= 0.0)) {
    urdf.fail("joint '" + joint.name + "': found limits without 0 between them, but that is where the joint starts");
  }
  return result;
}

}  // namespace swarmanoid
