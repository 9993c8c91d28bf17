#include "swarmanoid_space/state/joints.hpp"

#include <algorithm>

namespace swarmanoid {

void visitCell(StateVisitor& visitor, const char* name, const CellOwner& owner, Span<const JointState> joints) {
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const std::string& joint = owner.model.joints[i].name;
    visitor.number({name, joint, "angle"}, joints[i].angle);
    visitor.number({name, joint, "speed"}, joints[i].speed);
    if (visitor.wantsDetail()) {
      visitor.number({name, joint, "effort"}, joints[i].effort);
    }
  }
}

Eigen::Isometry3d displacementOf(const EntityModel& model, Span<const JointState> states, int joint) {
  // from the link down to the body: each joint turns the transform so far about its own place
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  while (joint >= 0) {
    const EntityModel::Joint& axis_joint = model.joints[static_cast<std::size_t>(joint)];
    const Eigen::Translation3d to_joint(axis_joint.frame.position);
    const Eigen::AngleAxisd turn(states.empty() ? 0.0 : states[static_cast<std::size_t>(joint)].angle, axis_joint.axis);
    result = to_joint * turn * to_joint.inverse() * result;
    joint = axis_joint.carrier;
  }
  return result;
}

CollisionShape placeOf(const EntityModel& model, Span<const JointState> states, const CollisionShape& shape) {
  const Eigen::Isometry3d displacement = displacementOf(model, states, shape.joint);
  CollisionShape result = shape;
  result.position = displacement * shape.position;
  result.orientation = Eigen::Quaterniond(displacement.linear()) * shape.orientation;
  return result;
}

std::shared_ptr<const EntityModel> posedModel(const std::shared_ptr<const EntityModel>& model,
                                              Span<const JointState> states) {
  const auto is_turned = [&](const CollisionShape& shape) {
    return shape.joint >= 0 &&
           !displacementOf(*model, states, shape.joint).isApprox(Eigen::Isometry3d::Identity(), 0.0);
  };
  if (std::none_of(model->shapes.begin(), model->shapes.end(), is_turned)) {
    return model;
  }
  auto posed = std::make_shared<EntityModel>(*model);
  for (CollisionShape& shape : posed->shapes) {
    shape = placeOf(*model, states, shape);
    shape.joint = -1;
  }
  posed->measureShapes();
  return posed;
}

Mount placeOf(const EntityModel& model, Span<const JointState> states, const std::string& mount_name) {
  const Mount& mount = model.mount(mount_name);
  const Eigen::Isometry3d displacement = displacementOf(model, states, mount.joint);
  Mount result = mount;
  result.position = displacement * mount.position;
  result.orientation = Eigen::Quaterniond(displacement.linear()) * mount.orientation;
  return result;
}

}  // namespace swarmanoid
