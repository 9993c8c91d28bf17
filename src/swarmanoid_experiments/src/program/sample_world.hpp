/// A world of one robot and one object in front of one of its sensors, to make tables of the sensor's readings.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "swarmanoid_experiment_files/samples/sampled_sensor.hpp"
#include "swarmanoid_space/sensor.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid::program {

class SampleWorld {
 public:
  /// @param sensor is configured, and is a SampledSensor @param number index of the sensor in the device, from 0
  /// @throws ConfigError if the robot has no such sensor
  SampleWorld(std::shared_ptr<Sensor> sensor, const std::string& robot, std::size_t number);
  SampleWorld(const SampleWorld&) = delete;
  SampleWorld& operator=(const SampleWorld&) = delete;

  Stimulus stimulus() const { return sampled_->stimulus(); }
  /// Maximum range of the sensor [m].
  double reach() const { return sampled_->reach(); }
  /// Reading of the sensor. An object exactly at the maximum range is detected.
  /// @param distance to the object [m] @param angle as in `Stimulus` [rad]
  double read(double distance, double angle);

 private:
  Row add(const std::string& name, const std::shared_ptr<const EntityModel>& model);
  void addThing();
  /// Places the robot so that the sensor has that position and direction, both in W.
  void aim(const Eigen::Vector3d& place, const Eigen::Vector3d& direction);
  void place(double distance, double angle);

  Space space_;
  std::shared_ptr<Sensor> sensor_;
  SampledSensor* sampled_;  // the same object as sensor_
  std::size_t number_;
  SampledSensor::Line line_;
  Row robot_;
  Row thing_ = kNoRow;
};

}  // namespace swarmanoid::program
