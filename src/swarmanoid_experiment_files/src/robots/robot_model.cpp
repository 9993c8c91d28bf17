// Creates models of robots from their URDF.
#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <set>

#include "robot_description.hpp"
#include "robot_files.hpp"
#include "robot_joints.hpp"
#include "robot_wheels.hpp"
#include "swarmanoid_experiment_files/robots/read_urdf.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_space/models/entity_model.hpp"
#include "swarmanoid_space/models/limits.hpp"
#include "urdf_checks.hpp"

namespace swarmanoid {
namespace {

bool isUpright(const CollisionShape& shape) {
  const Eigen::Vector3d axis = shape.orientation * Eigen::Vector3d::UnitZ();
  return std::hypot(axis.x(), axis.y()) < kSameDirection;
}

/// Builds the model of one robot, part by part.
class RobotReader {
 public:
  /// @param problems mistakes are added to it, and reading continues; null: mistakes are thrown
  RobotReader(const std::string& type, const std::string& file, std::vector<std::string>* problems)
      : urdf_(readUrdf(file)), problems_(problems) {
    for (const ConfigError& mistake : mistakesIn(urdf_)) {
      attempt([&] { throw ConfigError(mistake); });
    }
    description_ = readRobotDescription(*urdf_.document, file);  // required: it names the joints that are wheels
    model_->type = type;
    model_->title = description_.title;
    model_->holders = description_.holders;
    model_->devices = description_.devices;
    model_->is_robot = true;
    model_->is_movable = true;
    model_->urdf = urdf_.text;
  }

  std::shared_ptr<const EntityModel> read() {
    const urdf::LinkConstSharedPtr root = urdf_.robot->getRoot();
    attempt([&] {
      if (root->name != "base_link") {
        urdf_.fail("found '" + root->name + "' as the root link, expected 'base_link'");
      }
    });
    readLink(*root, Mount{}, -1);
    attempt([&] {
      if (!has_collision_) {
        urdf_.fail("found no collision element, expected at least one: without it the robot has no extent");
      }
    });
    attempt([&] {
      if (description_.wheels) {
        model_->wheels = readWheels(urdf_, *model_, *description_.wheels);
      }
    });
    attempt([&] { readGripper(); });
    attempt([&] { readLeds(); });
    model_->possible_battery = description_.battery;
    if (description_.rotors && model_->possible_battery) {
      model_->possible_battery->flight =
          hoverPower(model_->mass, description_.rotors->area, description_.rotors->efficiency);
    }
    model_->measureShapes();
    return model_;
  }

 private:
  template <class Part>
  void attempt(Part read_part) {
    try {
      read_part();
    } catch (const ConfigError& error) {
      if (problems_ == nullptr) {
        throw;
      }
      problems_->emplace_back(error.what());
    }
  }

  /// @param turned_by the nearest joint between the link and the body; -1: none
  void readLink(const urdf::Link& link, const Mount& frame, int turned_by) {
    Mount& mount = model_->mounts[link.name];
    mount = frame;
    mount.joint = turned_by;
    if (link.inertial != nullptr) {
      const Inertial inertial = readInertial(*link.inertial, frame);
      model_->addMass(inertial);
      (turned_by < 0 ? model_->body_part : model_->joints[static_cast<std::size_t>(turned_by)].part).add(inertial);
    }
    const bool is_strip = link.name == description_.gripping_strip;
    has_collision_ |= !is_strip && !link.collision_array.empty();
    for (const urdf::CollisionSharedPtr& collision : link.collision_array) {
      attempt([&] {
        CollisionShape shape = readShape(link.name, *collision, frame);
        shape.joint = turned_by;
        if (is_strip) {
          readStrip(shape);
        } else {
          model_->shapes.push_back(shape);
        }
      });
    }
    attempt([&] {
      if (is_strip && link.collision_array.empty()) {
        urdf_.fail("link '" + link.name + "': found no collision element, expected a cylinder");
      }
    });
    for (const urdf::JointSharedPtr& joint : link.child_joints) {
      const Mount child = chain(frame, toMount(joint->parent_to_joint_origin_transform));
      int turned_child_by = turned_by;
      if (isTurningJoint(*joint) && !isWheel(joint->name)) {
        attempt([&] { turned_child_by = addJoint(*joint, child, turned_by); });
      }
      readLink(*urdf_.robot->getLink(joint->child_link_name), child, turned_child_by);
    }
  }

  /// @return its index
  int addJoint(const urdf::Joint& joint, const Mount& frame, int carrier) {
    model_->joints.push_back(readJoint(urdf_, joint, frame, carrier));
    return static_cast<int>(model_->joints.size()) - 1;
  }

  static Inertial readInertial(const urdf::Inertial& inertial, const Mount& frame) {
    const Mount place = chain(frame, toMount(inertial.origin));
    const Eigen::Matrix3d turn = place.orientation.toRotationMatrix();
    return {inertial.mass, place.position, turn * inertiaOf(inertial) * turn.transpose()};
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
    const bool is_box = shape.kind == CollisionShape::Kind::kBox;
    const bool is_sphere = shape.kind == CollisionShape::Kind::kSphere;
    // sizes as in the file: a radius, or a whole length
    const Eigen::Vector3d sizes = shape.half_extent.cwiseProduct(is_box      ? Eigen::Vector3d(2.0, 2.0, 2.0)
                                                                 : is_sphere ? Eigen::Vector3d(1.0, 1.0, 1.0)
                                                                             : Eigen::Vector3d(1.0, 1.0, 2.0));
    for (const double size : sizes) {
      if (!limits::kLength.contains(size)) {
        urdf_.fail("link '" + link + "': found collision geometry with a size of " + numberText(size) +
                   " m, allowed: " + limits::kLength.toString());
      }
    }
    return shape;
  }

  void readStrip(const CollisionShape& shape) {
    if (shape.kind != CollisionShape::Kind::kCylinder || model_->gripping_radius || !isUpright(shape) ||
        shape.position.head<2>().norm() > kSamePlace) {
      urdf_.fail("link '" + description_.gripping_strip +
                 "': expected one collision element, an upright cylinder around the body's z axis");
    }
    model_->gripping_radius = shape.half_extent.x();
  }

  bool isWheel(const std::string& joint) const {
    return description_.wheels && (joint == description_.wheels->left || joint == description_.wheels->right);
  }

  void readGripper() {
    using Holder = EntityModel::Holder;
    const auto found = std::find_if(model_->holders.begin(), model_->holders.end(),
                                    [](const Holder& holder) { return holder.kind == Holder::Kind::kGripper; });
    if (found == model_->holders.end()) {
      return;
    }
    const Eigen::Vector3d& tip = model_->mount(found->mount).position;
    if (std::abs(tip.y()) > kSamePlace || tip.x() <= 0.0) {
      urdf_.fail("link '" + found->mount + "': found it at " + coordinates(tip) +
                 ", expected it straight ahead of the body's centre");
    }
    model_->gripper = EntityModel::Gripper{tip.x(), tip.z()};
  }

  void readLeds() {
    if (description_.leds.empty()) {
      return;
    }
    const std::string prefix = description_.leds + "_";
    const auto is_led = [&](const auto& mount) { return mount.first.rfind(prefix, 0) == 0; };
    const auto count = static_cast<std::size_t>(std::count_if(model_->mounts.begin(), model_->mounts.end(), is_led));
    if (count == 0 || count > EntityModel::kMaxLeds) {
      urdf_.fail("found " + std::to_string(count) + " links '" + prefix + "...', allowed are 1 to " +
                 std::to_string(EntityModel::kMaxLeds));
    }
    for (std::size_t i = 0; i < count; ++i) {
      const auto found = model_->mounts.find(prefix + std::to_string(i));
      if (found == model_->mounts.end()) {
        urdf_.fail("found " + std::to_string(count) + " links '" + prefix + "...' but no '" + prefix +
                   std::to_string(i) + "', expected them to be numbered from 0 without gaps");
      }
      model_->led_positions.push_back(found->second.position);
    }
  }

  UrdfFile urdf_;
  std::vector<std::string>* problems_;
  RobotDescription description_;
  bool has_collision_ = false;  ///< there are collision elements, readable or not
  std::shared_ptr<EntityModel> model_ = std::make_shared<EntityModel>();
};

/// @throws ConfigError if not exactly one package has a robot of that type
const std::string& fileOf(const std::string& type) {
  const RobotFiles& files = robotFiles();
  const RobotFile* found = nullptr;
  std::vector<std::string> types;
  for (const RobotFile& robot : files.robots) {
    types.push_back(robot.type);
    if (robot.type != type) {
      continue;
    }
    if (found != nullptr) {
      throw ConfigError({robot.file}, "found a second robot '" + type + "', allowed: one; the other is " + found->file);
    }
    found = &robot;
  }
  if (found == nullptr) {
    std::string problems;
    for (const std::string& problem : files.problems) {
      problems += "; " + problem;
    }
    const std::string allowed = types.empty() ? "none (no package with robots is installed)" : joinNames(types);
    throw ConfigError({},
                      "found no robot '" + type + "', allowed are: " + allowed + didYouMean(type, types) + problems);
  }
  return found->file;
}

}  // namespace

std::shared_ptr<const EntityModel> loadRobotModel(const std::string& type, const std::string& urdf_file) {
  return RobotReader(type, urdf_file, nullptr).read();
}

std::shared_ptr<const EntityModel> checkRobotFile(const std::string& type, const std::string& urdf_file,
                                                  std::vector<std::string>& problems) {
  const std::size_t before = problems.size();
  std::shared_ptr<const EntityModel> model;
  try {
    model = RobotReader(type, urdf_file, &problems).read();
  } catch (const ConfigError& error) {
    problems.emplace_back(error.what());
  }
  return problems.size() == before ? model : nullptr;
}

std::shared_ptr<const EntityModel> robotModel(const std::string& type) {
  static std::mutex mutex;
  static std::map<std::string, std::shared_ptr<const EntityModel>> loaded;
  const std::lock_guard<std::mutex> lock(mutex);
  std::shared_ptr<const EntityModel>& model = loaded[type];
  if (model == nullptr) {
    model = loadRobotModel(type, fileOf(type));
  }
  return model;
}

std::shared_ptr<const EntityModel> robotWithBattery(const EntityModel& robot, const BatteryModel& battery) {
  auto model = std::make_shared<EntityModel>(robot);
  model->battery = battery;
  // in the order of BatteryProperty
  model->properties = {
      {kCharge, "J", "Charge of the battery.", {0.0, battery.capacity}, battery.first_share * battery.capacity},
      {kCapacitor, "J", "Charge of the super-capacitor.", {0.0, battery.capacitor}, battery.capacitor},
      {kSupply, "W", "Power that charges the battery.", kPowerRange, 0.0}};
  return model;
}

std::vector<std::string> robotProblems() {
  std::vector<std::string> problems = robotFiles().problems;
  std::set<std::string> types;
  for (const RobotFile& robot : robotFiles().robots) {
    try {
      if (types.insert(robot.type).second) {
        robotModel(robot.type);
      }
    } catch (const ConfigError& error) {
      problems.emplace_back(error.what());
    }
  }
  return problems;
}

}  // namespace swarmanoid
