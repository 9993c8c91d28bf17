// Robots' models from their URDF.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <map>
#include <mutex>
#include <set>

#include "read_urdf.hpp"
#include "robot_joints.hpp"
#include "robot_wheels.hpp"
#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_space/models/entity_model.hpp"

namespace swarmanoid {
namespace {

constexpr const char* kPackage = "swarmanoid_description";

bool isUpright(const CollisionShape& shape) {
  const Eigen::Vector3d axis = shape.orientation * Eigen::Vector3d::UnitZ();
  return std::hypot(axis.x(), axis.y()) < kSamePlace;
}

/// Builds the model of one robot, part by part.
class RobotReader {
 public:
  RobotReader(const std::string& type, const std::string& file) : urdf_(readUrdf(file)) {
    model_->type = type;
    model_->title = type;
    model_->title.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(type.front())));
    model_->is_robot = true;
    model_->is_movable = true;
    model_->urdf = urdf_.text;
  }

  std::shared_ptr<const EntityModel> read() {
    const urdf::LinkConstSharedPtr root = urdf_.robot->getRoot();
    if (root->name != "base_link") {
      urdf_.fail("found '" + root->name + "' as the root link, expected 'base_link'");
    }
    readLink(*root, Mount{}, -1);
    if (model_->shapes.empty()) {
      urdf_.fail("found no collision element, expected at least one: without it the robot has no extent");
    }
    model_->wheels = readWheels(urdf_, *model_);
    readGripper();
    readLeds();
    model_->measureShapes();
    return model_;
  }

 private:
  /// @param turned_by the joint that turns the link, or what carries it; -1: none
  void readLink(const urdf::Link& link, const Mount& frame, int turned_by) {
    Mount& mount = model_->mounts[link.name];
    mount = frame;
    mount.joint = turned_by;
    if (link.inertial != nullptr) {
      const Inertial inertial = readInertial(*link.inertial, frame);
      model_->addMass(inertial);
      (turned_by < 0 ? model_->body_part : model_->joints[static_cast<std::size_t>(turned_by)].part).add(inertial);
    }
    for (const urdf::CollisionSharedPtr& collision : link.collision_array) {
      CollisionShape shape = readShape(link.name, *collision, frame);
      shape.joint = turned_by;
      if (link.name == "gripping_strip") {
        readStrip(shape);
      } else {
        model_->shapes.push_back(shape);
      }
    }
    if (link.name == "gripping_strip" && !model_->gripping_radius) {
      urdf_.fail("link 'gripping_strip': found no collision element, expected a cylinder");
    }
    for (const urdf::JointSharedPtr& joint : link.child_joints) {
      const Mount child = chain(frame, toMount(joint->parent_to_joint_origin_transform));
      const bool turns = isTurningJoint(*joint) && !isWheelJoint(joint->name);
      readLink(*urdf_.robot->getLink(joint->child_link_name), child,
               turns ? addJoint(*joint, child, turned_by) : turned_by);
    }
  }

  /// @return its index
  int addJoint(const urdf::Joint& joint, const Mount& frame, int carrier) {
    if (model_->joints.size() == EntityModel::kMaxJoints) {
      urdf_.fail("joint '" + joint.name + "': allowed are at most " + std::to_string(EntityModel::kMaxJoints) +
                 " joints besides the wheels");
    }
    model_->joints.push_back(readJoint(urdf_, joint, frame, carrier));
    return static_cast<int>(model_->joints.size()) - 1;
  }

  static Inertial readInertial(const urdf::Inertial& inertial, const Mount& frame) {
    const Mount place = chain(frame, toMount(inertial.origin));
    Eigen::Matrix3d inertia;
    inertia << inertial.ixx, inertial.ixy, inertial.ixz,  //
        inertial.ixy, inertial.iyy, inertial.iyz,         //
        inertial.ixz, inertial.iyz, inertial.izz;
    const Eigen::Matrix3d turn = place.orientation.toRotationMatrix();
    return {inertial.mass, place.position, turn * inertia * turn.transpose()};
  }

  CollisionShape readShape(const std::string& link, const urdf::Collision& collision, const Mount& frame) const {
    const Mount place = chain(frame, toMount(collision.origin));
    CollisionShape shape;
    shape.position = place.position;
    shape.orientation = place.orientation;
    if (const auto* cylinder = dynamic_cast<const urdf::Cylinder*>(collision.geometry.get())) {
      shape.kind = CollisionShape::Kind::kCylinder;
      shape.half_extent = {cylinder->radius, cylinder->radius, cylinder->length / 2.0};
    } else if (const auto* box = dynamic_cast<const urdf::Box*>(collision.geometry.get())) {
      shape.kind = CollisionShape::Kind::kBox;
      shape.half_extent = {box->dim.x / 2.0, box->dim.y / 2.0, box->dim.z / 2.0};
    } else if (const auto* sphere = dynamic_cast<const urdf::Sphere*>(collision.geometry.get())) {
      shape.kind = CollisionShape::Kind::kSphere;
      shape.half_extent.setConstant(sphere->radius);
    } else {
      urdf_.fail("link '" + link + "': found a mesh as collision geometry, allowed are box, cylinder and sphere");
    }
    if (!(shape.half_extent.minCoeff() > 0.0)) {
      urdf_.fail("link '" + link + "': found collision geometry with a size of 0 or less, expected more");
    }
    return shape;
  }

  void readStrip(const CollisionShape& shape) {
    if (shape.kind != CollisionShape::Kind::kCylinder || model_->gripping_radius || !isUpright(shape) ||
        shape.position.head<2>().norm() > kSamePlace) {
      urdf_.fail("link 'gripping_strip': expected one collision element, an upright cylinder around the body's z axis");
    }
    model_->gripping_radius = shape.half_extent.x();
  }

  void readGripper() {
    const auto found = model_->mounts.find("gripper_tip");
    if (found == model_->mounts.end()) {
      return;
    }
    const Eigen::Vector3d& tip = found->second.position;
    if (std::abs(tip.y()) > kSamePlace || tip.x() <= 0.0) {
      urdf_.fail("link 'gripper_tip': found it at " + coordinates(tip) +
                 ", expected it straight ahead of the body's centre");
    }
    model_->gripper = EntityModel::Gripper{tip.x(), tip.z()};
  }

  void readLeds() {
    const auto is_led = [](const auto& mount) { return mount.first.rfind("led_", 0) == 0; };
    const auto count = static_cast<std::size_t>(std::count_if(model_->mounts.begin(), model_->mounts.end(), is_led));
    if (count > EntityModel::kMaxLeds) {
      urdf_.fail("found " + std::to_string(count) + " LEDs, allowed are at most " +
                 std::to_string(EntityModel::kMaxLeds));
    }
    for (std::size_t i = 0; i < count; ++i) {
      const auto found = model_->mounts.find("led_" + std::to_string(i));
      if (found == model_->mounts.end()) {
        urdf_.fail("found " + std::to_string(count) + " links 'led_...' but no 'led_" + std::to_string(i) +
                   "', expected them to be numbered from 0 without gaps");
      }
      model_->led_positions.push_back(found->second.position);
    }
  }

  UrdfFile urdf_;
  std::shared_ptr<EntityModel> model_ = std::make_shared<EntityModel>();
};

/// Types of this installation, for messages.
std::vector<std::string> robotTypes() {
  std::set<std::string> types;
  for (const std::string& folder : shareFolders()) {
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder + "/" + kPackage + "/urdf", ignored)) {
      if (entry.path().extension() == ".urdf") {
        types.insert(entry.path().stem().string());
      }
    }
  }
  return {types.begin(), types.end()};
}

}  // namespace

std::shared_ptr<const EntityModel> loadRobotModel(const std::string& type, const std::string& urdf_file) {
  return RobotReader(type, urdf_file).read();
}

std::shared_ptr<const EntityModel> robotModel(const std::string& type) {
  static std::mutex mutex;
  static std::map<std::string, std::shared_ptr<const EntityModel>> loaded;
  const std::lock_guard<std::mutex> lock(mutex);
  std::shared_ptr<const EntityModel>& model = loaded[type];
  if (model == nullptr) {
    const std::string file = findShared(kPackage, "urdf/" + type + ".urdf");
    if (file.empty()) {
      const std::vector<std::string> types = robotTypes();
      const std::string allowed =
          types.empty() ? "none (package swarmanoid_description is not installed)" : joinNames(types);
      throw ConfigError({}, "found no robot '" + type + "', allowed are: " + allowed + didYouMean(type, types));
    }
    model = loadRobotModel(type, file);
  }
  return model;
}

}  // namespace swarmanoid
