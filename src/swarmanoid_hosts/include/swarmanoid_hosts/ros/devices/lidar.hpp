/// Defines the topic of devices/lidar.hpp, and converts the device to a message and back.
#pragma once

#include <sensor_msgs/LaserScan.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/devices/lidar.hpp"

namespace swarmanoid {

/// All beams are measured at one moment: time_increment is 0.
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

/// The beams are stored in `parts` in order of increasing angle from -pi, whereas drivers may count from 0 to 2 pi, or
/// downwards. Ranges outside the scan's limits are converted by REP-117, so the 0 that drivers send for beams without
/// a return becomes -infinity. A received scan has the age 0 until the next scan, since messages do not contain it.
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
  constexpr double kHalfTurn = M_PI + 1e-6;  // the float next to pi is larger than pi
  const Range range{static_cast<double>(message.range_min), static_cast<double>(message.range_max)};
  for (std::size_t i = 0; i < count; ++i) {
    const double angle =
        static_cast<double>(message.angle_min) + static_cast<double>(i) * static_cast<double>(message.angle_increment);
    const double within = std::abs(angle) <= kHalfTurn ? angle : wrapAngle(angle);
    beams[i] = {Distance::reading(static_cast<double>(message.ranges[i]), range), static_cast<float>(within)};
  }
  if (message.angle_increment < 0.0F) {
    std::reverse(beams, beams + count);
  }
  const auto by_angle = [](const LidarBeam& a, const LidarBeam& b) { return a.angle < b.angle; };
  std::rotate(beams, std::min_element(beams, beams + count, by_angle), beams + count);
  lidar.beams = Span<const LidarBeam>(beams, count);
}

REGISTER_DEVICE_TOPIC(Lidar, sensor_msgs::LaserScan, kReading, "scan", "lidar")

}  // namespace swarmanoid
