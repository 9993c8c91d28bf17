#include "swarmanoid_space/joints.hpp"

namespace swarmanoid {

Eigen::Isometry3d displacementOf(const EntityModel& model, const JointState* states, int joint) {
  // from the link down to the body: each joint turns all that was gathered so far about its own place
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  while (joint >= 0) {
    const EntityModel::Joint& its = model.joints[static_cast<std::size_t>(joint)];
    const Eigen::Translation3d to_joint(its.frame.position);
    const Eigen::AngleAxisd turn(states[joint].angle, its.axis);
    result = to_joint * turn * to_joint.inverse() * result;
    joint = its.carrier;
  }
  return result;
}

Mount placeOf(const EntityModel& model, const JointState* states, const std::string& mount_name) {
  const Mount& mount = model.mount(mount_name);
  const Eigen::Isometry3d displacement = displacementOf(model, states, mount.joint);
  Mount result = mount;
  result.position = displacement * mount.position;
  result.orientation = Eigen::Quaterniond(displacement.linear()) * mount.orientation;
  return result;
}

}  // namespace swarmanoid
