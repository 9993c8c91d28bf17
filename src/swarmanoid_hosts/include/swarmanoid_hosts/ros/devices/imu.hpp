/// Defines the topic of devices/imu.hpp, and converts its device to messages and back.
#pragma once

#include <sensor_msgs/Imu.h>

#include <stdexcept>
#include <string>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/devices/imu.hpp"

namespace swarmanoid {

namespace detail {

/// First element of a covariance whose values are not measured (sensor_msgs/Imu).
constexpr double kNotMeasured = -1.0;

template <class Covariance>
void refuseUnlessMeasured(const char* name, const Covariance& covariance) {
  if (covariance[0] == kNotMeasured) {
    throw std::runtime_error("found " + std::string(name) + "_covariance[0] = -1 (not measured), allowed: 0 or more");
  }
}

}  // namespace detail

/// The orientation is marked as not measured; the covariances of the others are 0 (unknown).
inline void toMessage(const Imu& readings, sensor_msgs::Imu& message) {
  message.orientation.w = 1.0;  // a valid quaternion, for programs that do not check the covariance
  message.orientation_covariance[0] = detail::kNotMeasured;
  message.angular_velocity.x = readings.angular_velocity.x();
  message.angular_velocity.y = readings.angular_velocity.y();
  message.angular_velocity.z = readings.angular_velocity.z();
  message.linear_acceleration.x = readings.linear_acceleration.x();
  message.linear_acceleration.y = readings.linear_acceleration.y();
  message.linear_acceleration.z = readings.linear_acceleration.z();
}

/// The orientation is ignored, even if the unit measures it.
inline void fromMessage(const sensor_msgs::Imu& message, Imu& readings) {
  detail::refuseUnlessMeasured("angular_velocity", message.angular_velocity_covariance);
  detail::refuseUnlessMeasured("linear_acceleration", message.linear_acceleration_covariance);
  readings.angular_velocity = {message.angular_velocity.x, message.angular_velocity.y, message.angular_velocity.z};
  readings.linear_acceleration = {message.linear_acceleration.x, message.linear_acceleration.y,
                                  message.linear_acceleration.z};
}

REGISTER_DEVICE_TOPIC(Imu, sensor_msgs::Imu, kReading, "imu/data", "base_link")

}  // namespace swarmanoid
