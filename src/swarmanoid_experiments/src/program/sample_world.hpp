/// A world of one robot and one thing before one of its sensors, to make tables of what the sensor reads.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "swarmanoid_space/samples/sampled_sensor.hpp"
#include "swarmanoid_space/sensor.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid::program {

class SampleWorld {
 public:
  /// @param sensor is configured, and is a SampledSensor @param number of the one of the device that is read, from 0
  /// @throws ConfigError if the robot has no such sensor
  SampleWorld(std::shared_ptr<Sensor> sensor, const std::string& robot, std::size_t number);
  SampleWorld(const SampleWorld&) = delete;
  SampleWorld& operator=(const SampleWorld&) = delete;

  Stimulus stimulus() const { return sampled_->stimulus(); }
  /// As far as the sensor feels anything [m].
  double reach() const { return sampled_->reach(); }
  /// What it reads. What stands just where it ceases to feel is felt.
  /// @param distance to the thing [m] @param angle as `Stimulus` has it [rad]
  double read(double distance, double angle);

 private:
  Row add(const std::string& name, const std::shared_ptr<const EntityModel>& model);
  void addThing();
  /// Puts the robot so that the sensor is there and looks in that direction, both in W.
  void aim(const Eigen::Vector3d& place, const Eigen::Vector3d& direction);
  void place(double distance, double angle);

  Space space_;
  std::shared_ptr<Sensor> sensor_;
  SampledSensor* sampled_;  // the same object
  std::size_t number_;
  SampledSensor::Line line_;
  Row robot_;
  Row thing_ = kNoRow;
};

}  // namespace swarmanoid::program
