#include "sample_world.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/expects.hpp"
#include "swarmanoid_space/models/entity_model.hpp"

namespace swarmanoid::program {
namespace {

// The objects are far enough from the floor and the sides of the arena not to touch them.
const Eigen::Vector3d world_size(400.0, 400.0, 400.0);  // m
const Eigen::Vector3d middle(200.0, 200.0, 200.0);      // m
const Eigen::Vector3d wall_size(0.1, 4.0, 4.0);         // m
constexpr double kNearer = 1e-9;                        // m, distance to stay below the reach

void refuseForeignRobot(const std::string& device, const EntityModel& robot) {
  const DeviceType* type = findDeviceType(device);
  const bool is_carried = type == nullptr || type->robot.empty() || type->robot == robot.type ||
                          std::find(robot.devices.begin(), robot.devices.end(), device) != robot.devices.end();
  if (!is_carried) {
    throw ConfigError({"--robot", 0}, "found '" + robot.type + "', which has no '" + device +
                                          "', allowed: " + type->robot + ", and robots that carry it");
  }
}

}  // namespace

SampleWorld::SampleWorld(std::shared_ptr<Sensor> sensor, const std::string& robot, std::size_t number)
    : sensor_(std::move(sensor)), sampled_(dynamic_cast<SampledSensor*>(sensor_.get())), number_(number) {
  SWARMANOID_EXPECTS(sampled_ != nullptr);
  const auto model = robotModel(robot);
  refuseForeignRobot(sensor_->type(), *model);
  space_.size = world_size;
  space_.clocktick = std::chrono::milliseconds(100);
  space_.floor.bare = colors::kWhite;
  space_.index.configure(space_.size, PositionalIndex::Optimization::k3D, 2);
  robot_ = add("robot", model);
  sensor_->add(space_, robot_);
  if (number_ >= sampled_->sensorCount()) {
    throw ConfigError({"--sensor", 0}, "found " + std::to_string(number_) + ", allowed: from 0 to " +
                                           std::to_string(sampled_->sensorCount() - 1));
  }
  line_ = sampled_->line(number_);
  addThing();
}

Row SampleWorld::add(const std::string& name, const std::shared_ptr<const EntityModel>& model) {
  const Row row = space_.entities.add(name, model, {middle, Eigen::Quaterniond::Identity()}, colors::kWhite);
  space_.entities_without_engine.place(space_.entities, row);
  return row;
}

void SampleWorld::addThing() {
  if (stimulus() == Stimulus::kObstacle) {
    thing_ = add("wall", blockModel(wall_size));
  } else if (stimulus() == Stimulus::kLight) {
    thing_ = add("lamp", lightModel(1.0));
  }
}

void SampleWorld::aim(const Eigen::Vector3d& place, const Eigen::Vector3d& direction) {
  Pose& pose = space_.entities.pose[robot_];
  pose.orientation = Eigen::Quaterniond::FromTwoVectors(line_.direction, direction);
  pose.position = place - pose.orientation * line_.from;
}

void SampleWorld::place(double distance, double angle) {
  const Eigen::Vector3d aside(std::cos(angle), std::sin(angle), 0.0);
  if (stimulus() == Stimulus::kFloor) {
    aim({middle.x(), middle.y(), distance * std::cos(angle)}, {std::sin(angle), 0.0, -std::cos(angle)});
    return;
  }
  aim(middle, Eigen::Vector3d::UnitX());
  Pose& pose = space_.entities.pose[thing_];
  if (stimulus() == Stimulus::kLight) {
    pose.position = middle + distance * aside;
    return;
  }
  // the sensor's line of sight hits the centre of a face at every angle
  pose.orientation = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ());
  pose.position = middle + distance * Eigen::Vector3d::UnitX() + 0.5 * wall_size.x() * aside;
}

double SampleWorld::read(double distance, double angle) {
  place(distance == reach() ? distance - kNearer : distance, angle);
  space_.entities_without_engine.refresh(space_.entities);
  space_.index.rebuild(space_.entities);
  sensor_->prepare(space_);
  sensor_->sense(space_, 0, 1);
  return sampled_->reading(number_);
}

}  // namespace swarmanoid::program
