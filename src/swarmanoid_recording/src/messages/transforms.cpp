#include "swarmanoid_recording/messages/transforms.hpp"

#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include "swarmanoid_experiment_files/robots/read_urdf.hpp"
#include "swarmanoid_hosts/ros/device_messages.hpp"
#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/devices/odometry.hpp"
#include "swarmanoid_recording/messages/world_state.hpp"

namespace swarmanoid {
namespace {

geometry_msgs::TransformStamped transform(const ros::Time& stamp, const std::string& parent, const std::string& child,
                                          const Eigen::Vector3d& position, const Eigen::Quaterniond& orientation) {
  geometry_msgs::TransformStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = parent;
  message.child_frame_id = child;
  message.transform.translation.x = position.x();
  message.transform.translation.y = position.y();
  message.transform.translation.z = position.z();
  message.transform.rotation.x = orientation.x();
  message.transform.rotation.y = orientation.y();
  message.transform.rotation.z = orientation.z();
  message.transform.rotation.w = orientation.w();
  return message;
}

}  // namespace

std::optional<TransformLevel> parseTransformLevel(const std::string& text) {
  if (text == "auto") {
    return std::nullopt;
  }
  if (text == "none") {
    return TransformLevel::kNone;
  }
  if (text == "base") {
    return TransformLevel::kBase;
  }
  if (text == "full") {
    return TransformLevel::kFull;
  }
  throw ConfigError({}, "level of transforms: found '" + text + "', allowed: auto, none, base, full" +
                            didYouMean(text, {"auto", "none", "base", "full"}));
}

TransformLevel Transforms::level(const Space& space) {
  if (!level_) {
    std::size_t robots = 0;
    for (const Row row : space.entities.order) {
      robots += space.entities.model[row]->is_robot ? 1 : 0;
    }
    level_ = robots <= kFewRobots ? TransformLevel::kFull : TransformLevel::kBase;
  }
  return *level_;
}

const std::vector<Transforms::Link>& Transforms::linksOf(const EntityModel& model) {
  const auto [known, is_new] = links_.try_emplace(model.type);
  if (is_new && !model.urdf.empty()) {
    const urdf::ModelInterfaceSharedPtr robot = urdf::parseURDF(model.urdf);
    for (const auto& [name, joint] : robot->joints_) {
      Link link;
      link.parent = joint->parent_link_name;
      link.name = joint->child_link_name;
      link.place = toMount(joint->parent_to_joint_origin_transform);
      link.axis = {joint->axis.x, joint->axis.y, joint->axis.z};
      if (model.wheels && (name == model.wheels->left_joint || name == model.wheels->right_joint)) {
        link.wheel = name == model.wheels->left_joint ? Wheel::kLeft : Wheel::kRight;
      }
      link.joint = model.findJoint(name);
      known->second.push_back(link);
    }
  }
  return known->second;
}

const tf2_msgs::TFMessage& Transforms::moving(const Space& space) {
  const Entities& entities = space.entities;
  moving_.transforms.clear();
  if (level(space) == TransformLevel::kNone) {
    return moving_;
  }
  const ros::Time stamp = stampOf(space);
  for (const Row row : entities.order) {
    const EntityModel& model = *entities.model[row];
    if (!model.is_movable) {
      continue;
    }
    const std::string& name = entities.name[row];
    const Pose& pose = entities.pose[row];
    moving_.transforms.push_back(transform(stamp, kWorldFrame, frameOf(name), pose.position, pose.orientation));
    if (odometry_ == OdometryFrames::kShown) {
      addOdometry(space, row);
    }
    if (level(space) != TransformLevel::kFull || (!model.wheels && model.joints.empty())) {
      continue;
    }
    const WheelTurns& turns = space.wheel_turns[row];
    for (const Link& link : linksOf(model)) {
      if (link.wheel || link.joint >= 0) {
        const double angle = link.wheel ? wrapAngle(*link.wheel == Wheel::kLeft ? turns.left : turns.right)
                                        : space.joints[row][link.joint].angle;
        const Eigen::Quaterniond turned = link.place.orientation * Eigen::AngleAxisd(angle, link.axis.normalized());
        moving_.transforms.push_back(
            transform(stamp, frameOf(name, link.parent), frameOf(name, link.name), link.place.position, turned));
      }
    }
  }
  return moving_;
}

void Transforms::addOdometry(const Space& space, Row row) {
  const std::optional<ros::Time> stamp = sensedAt(space, row);
  const auto* odometry = space.readings.find<Odometry>(row);
  if (stamp && odometry != nullptr) {
    // expressed in base_link: the inverse of the pose that odometry estimates
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(-odometry->heading, Eigen::Vector3d::UnitZ()));
    const Eigen::Vector3d position = -(turn * Eigen::Vector3d(odometry->x, odometry->y, 0.0));
    const std::string& name = space.entities.name[row];
    moving_.transforms.push_back(transform(*stamp, frameOf(name), frameOf(name, "odom"), position, turn));
  }
}

const tf2_msgs::TFMessage& Transforms::fixed(const Space& space) {
  const Entities& entities = space.entities;
  fixed_.transforms.clear();
  if (level(space) == TransformLevel::kNone) {
    return fixed_;
  }
  const ros::Time stamp = stampOf(space);
  for (const Row row : entities.order) {
    const EntityModel& model = *entities.model[row];
    const std::string& name = entities.name[row];
    if (!model.is_movable) {
      const Pose& pose = entities.pose[row];
      fixed_.transforms.push_back(transform(stamp, kWorldFrame, frameOf(name), pose.position, pose.orientation));
    }
    if (level(space) == TransformLevel::kFull) {
      for (const Link& link : linksOf(model)) {
        if (!link.wheel && link.joint < 0) {
          fixed_.transforms.push_back(transform(stamp, frameOf(name, link.parent), frameOf(name, link.name),
                                                link.place.position, link.place.orientation));
        }
      }
    }
  }
  return fixed_;
}

}  // namespace swarmanoid
