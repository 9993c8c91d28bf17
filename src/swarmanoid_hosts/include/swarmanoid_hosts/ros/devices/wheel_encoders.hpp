/// Defines the topic of devices/wheel_encoders.hpp, and converts its device to messages and back.
#pragma once

#include <swarmanoid_msgs/WheelEncoders.h>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/devices/wheel_encoders.hpp"

namespace swarmanoid {

inline void toMessage(const WheelEncoders& readings, swarmanoid_msgs::WheelEncoders& message) {
  message.left_turned = readings.left.turned;
  message.right_turned = readings.right.turned;
  message.left_step = readings.left.step;
  message.right_step = readings.right.step;
  message.left_speed = readings.left.speed;
  message.right_speed = readings.right.speed;
}

inline void fromMessage(const swarmanoid_msgs::WheelEncoders& message, WheelEncoders& readings) {
  readings.left = {message.left_turned, message.left_step, message.left_speed};
  readings.right = {message.right_turned, message.right_step, message.right_speed};
}

REGISTER_DEVICE_TOPIC(WheelEncoders, swarmanoid_msgs::WheelEncoders, kReading, "wheels/encoders", "base_link")

}  // namespace swarmanoid
