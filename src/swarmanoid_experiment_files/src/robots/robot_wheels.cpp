#include "robot_wheels.hpp"

#include <algorithm>
#include <cmath>

namespace swarmanoid {
namespace {

using Eigen::Vector3d;

struct Wheel {
  Vector3d position = Vector3d::Zero();  ///< in the body frame [m]
  double radius = 0.0;                   ///< [m]
  double max_speed = 0.0;                ///< [rad/s]
};

double cylinderRadius(const urdf::GeometrySharedPtr& geometry) {
  const auto* cylinder = dynamic_cast<const urdf::Cylinder*>(geometry.get());
  return cylinder == nullptr ? 0.0 : cylinder->radius;
}

double wheelRadius(const UrdfFile& urdf, const urdf::Link& link) {
  // the widest cylinder is the tread; narrower ones are hubs
  double radius = 0.0;
  for (const urdf::CollisionSharedPtr& collision : link.collision_array) {
    radius = std::max(radius, cylinderRadius(collision->geometry));
  }
  for (const urdf::VisualSharedPtr& visual : link.visual_array) {
    radius = std::max(radius, cylinderRadius(visual->geometry));
  }
  if (radius == 0.0) {
    urdf.fail("link '" + link.name + "': found no cylinder, expected one as wide as the wheel");
  }
  return radius;
}

Wheel readWheel(const UrdfFile& urdf, const EntityModel& model, const urdf::Joint& joint) {
  if (joint.type != urdf::Joint::CONTINUOUS) {
    urdf.fail("joint '" + joint.name + "': expected the type 'continuous'");
  }
  const Mount& mount = model.mount(joint.child_link_name);
  const Vector3d axis = mount.orientation * Vector3d(joint.axis.x, joint.axis.y, joint.axis.z).normalized();
  if (!((axis - Vector3d::UnitY()).norm() < kSameDirection)) {
    urdf.fail("joint '" + joint.name + "': found the axis " + coordinates(axis) +
              " in the body frame, expected 0 1 0 (a positive turn drives ahead)");
  }
  if (joint.limits == nullptr || !(joint.limits->velocity > 0.0)) {
    urdf.fail("joint '" + joint.name + "': found no limit of its velocity, expected one above 0 rad/s");
  }
  return {mount.position, wheelRadius(urdf, *urdf.robot->getLink(joint.child_link_name)), joint.limits->velocity};
}

}  // namespace

EntityModel::Wheels readWheels(const UrdfFile& urdf, const EntityModel& model, const RobotDescription::Wheels& joints) {
  const Wheel left = readWheel(urdf, model, *urdf.robot->getJoint(joints.left));
  const Wheel right = readWheel(urdf, model, *urdf.robot->getJoint(joints.right));
  const Vector3d mirrored(-left.position.x(), -left.position.y(), left.position.z());
  if (!(left.position.y() > 0.0 && std::abs(left.position.x()) < kSamePlace &&
        (right.position - mirrored).norm() < kSamePlace)) {
    urdf.fail("found the wheels at " + coordinates(left.position) + " and " + coordinates(right.position) +
              ", expected them left and right of the body's centre at equal distances");
  }
  if (left.radius != right.radius || left.max_speed != right.max_speed) {
    urdf.fail("found wheels that differ in radius or in limit of velocity, expected equal ones");
  }
  EntityModel::Wheels wheels;
  wheels.radius = left.radius;
  wheels.separation = left.position.y() - right.position.y();
  wheels.max_speed = left.max_speed;
  wheels.left_joint = joints.left;
  wheels.right_joint = joints.right;
  return wheels;
}

}  // namespace swarmanoid
