/// Defines the topic of devices/lidar.hpp, and converts the device to a message and back.
#pragma once

#include <sensor_msgs/LaserScan.h>

#include <stdexcept>
#include <string>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/devices/lidar.hpp"

namespace swarmanoid {

/// All beams are of one moment, that of the stamp: time_increment is 0.
inline void toMessage(const Lidar& lidar, sensor_msgs::LaserScan& message) {
  const std::size_t count = lidar.beams.size();
  message.angle_min = count == 0 ? 0.0F : lidar.beams[0].angle;
  message.angle_max = count == 0 ? 0.0F : lidar.beams[count - 1].angle;
  message.angle_increment = count < 2 ? 0.0F : (message.angle_max - message.angle_min) / static_cast<float>(count - 1);
  message.time_increment = 0.0F;
  message.scan_time = lidar.scan_time;
  message.range_min = lidar.range_min;
  message.range_max = lidar.range_max;
  message.intensities.clear();
  message.ranges.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    message.ranges[i] = lidar.beams[i].range;
  }
}

/// The beams are stored in `parts`. A scan that has come is new: its age is 0.
inline void fromMessage(const sensor_msgs::LaserScan& message, Lidar& lidar, VariableParts& parts) {
  const std::size_t count = message.ranges.size();
  if (count > Lidar::kMostBeams) {
    throw std::runtime_error("found " + std::to_string(count) + " ranges, allowed: at most " +
                             std::to_string(Lidar::kMostBeams));
  }
  lidar.range_min = message.range_min;
  lidar.range_max = message.range_max;
  lidar.scan_time = message.scan_time;
  lidar.age = 0.0;
  parts.clear();
  auto* beams = parts.room<LidarBeam>(count);
  for (std::size_t i = 0; i < count; ++i) {
    beams[i] = {message.ranges[i], message.angle_min + static_cast<float>(i) * message.angle_increment};
  }
  lidar.beams = Span<const LidarBeam>(beams, count);
}

REGISTER_DEVICE_TOPIC(Lidar, sensor_msgs::LaserScan, kReading, "scan", "lidar")

}  // namespace swarmanoid
