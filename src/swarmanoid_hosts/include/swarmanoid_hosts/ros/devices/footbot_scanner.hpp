/// Defines the topics of devices/footbot_scanner.hpp, and converts its devices to messages and back.
#pragma once

#include <sensor_msgs/LaserScan.h>
#include <swarmanoid_msgs/ScannerCommand.h>
#include <swarmanoid_msgs/ScannerReadings.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/devices/footbot_scanner.hpp"

namespace swarmanoid {

namespace detail {

/// Copies from device to message, or back: the fields have the same names.
template <class From, class To>
void copyScannerReadings(const From& from, To& to) {
  const auto copy = [](const auto& source, auto& target) { std::copy(source.begin(), source.end(), target.begin()); };
  to.angle = from.angle;
  to.period = from.period;
  copy(from.angles, to.angles);
  copy(from.short_ahead, to.short_ahead);
  copy(from.long_left, to.long_left);
  copy(from.short_behind, to.short_behind);
  copy(from.long_right, to.long_right);
}

}  // namespace detail

inline void toMessage(const FootbotScanner& command, swarmanoid_msgs::ScannerCommand& message) {
  message.mode = static_cast<std::uint8_t>(command.mode);
  message.angle = command.angle;
  message.speed = command.speed;
}

inline void fromMessage(const swarmanoid_msgs::ScannerCommand& message, FootbotScanner& command) {
  if (message.mode > swarmanoid_msgs::ScannerCommand::ANGLE) {
    throw std::runtime_error("found mode " + std::to_string(message.mode) + ", allowed: 0 (OFF), 1 (SPEED), 2 (ANGLE)");
  }
  command = {static_cast<FootbotScanner::Mode>(message.mode), message.angle, message.speed};
}

inline void toMessage(const FootbotScannerReadings& readings, swarmanoid_msgs::ScannerReadings& message) {
  detail::copyScannerReadings(readings, message);
}

inline void fromMessage(const swarmanoid_msgs::ScannerReadings& message, FootbotScannerReadings& readings) {
  detail::copyScannerReadings(message, readings);
}

/// A scan of the whole turn. Each sample of the tick is entered in the direction of its beam, to half a degree; all
/// other directions have NaN (not measured). A short beam with nothing in range leaves NaN too, since a long one could
/// measure an obstacle there. If two samples have the same direction, a distance takes precedence over "too close",
/// which takes precedence over "nothing"; of two distances the smaller one is used.
///
/// All samples of a tick are relative to the robot's position at the stamp, and neighbours in the scan may come from
/// different beams. No time from one to the next would be right for all, so time_increment is 0.
inline void toMessage(const FootbotScannerReadings& readings, sensor_msgs::LaserScan& message) {
  constexpr std::size_t kBins = 360;
  constexpr float kInfinite = std::numeric_limits<float>::infinity();
  constexpr double kStep = 2.0 * M_PI / kBins;
  message.angle_min = static_cast<float>(-M_PI);
  message.angle_max = static_cast<float>(M_PI - kStep);
  message.angle_increment = static_cast<float>(kStep);
  message.time_increment = 0.0F;
  message.scan_time = readings.period;
  message.range_min = static_cast<float>(FootbotScannerReadings::kShortRange.minimum);
  message.range_max = static_cast<float>(FootbotScannerReadings::kLongRange.maximum);
  message.intensities.clear();
  message.ranges.assign(kBins, std::numeric_limits<float>::quiet_NaN());
  const auto says_more = [](float found, float known) {
    const auto rank = [](float range) {
      return std::isnan(range) ? 0 : range == kInfinite ? 1 : range == -kInfinite ? 2 : 3;
    };
    return rank(found) > rank(known) || (rank(found) == 3 && rank(known) == 3 && found < known);
  };
  for (std::size_t beam = 0; beam < FootbotScannerReadings::kBeams; ++beam) {
    for (std::size_t i = 0; i < FootbotScannerReadings::kSamples; ++i) {
      const float range = readings.distances(beam)[i];
      if (range == kInfinite && !FootbotScannerReadings::isLong(beam)) {
        continue;
      }
      const double angle = static_cast<double>(readings.angles[i]) + FootbotScannerReadings::offset(beam) + M_PI;
      float& known = message.ranges[static_cast<std::size_t>(std::lround(angle / kStep)) % kBins];
      known = says_more(range, known) ? range : known;
    }
  }
}

/// @throws std::runtime_error always: a scan does not tell which beam measured which distance
inline void fromMessage(const sensor_msgs::LaserScan& /*message*/, FootbotScannerReadings& /*readings*/) {
  throw std::runtime_error("found a scan, allowed: the readings of the beams, of which a scan is made");
}

REGISTER_DEVICE_TOPIC(FootbotScanner, swarmanoid_msgs::ScannerCommand, kCommand, "scanner/command")
REGISTER_DEVICE_TOPIC(FootbotScannerReadings, swarmanoid_msgs::ScannerReadings, kReading, "scanner_readings", "scanner")
REGISTER_DEVICE_TOPIC(FootbotScannerReadings, sensor_msgs::LaserScan, kReading, "scan", "scanner")

}  // namespace swarmanoid
