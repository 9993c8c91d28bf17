/// Sensors that had more in sight than they can report: how often in a run, device by device.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace swarmanoid {

/// One device of one robot. It outlives its robot, as a part of what the run's results are worth.
struct Overflow {
  std::string robot;
  std::string device;            ///< its type, such as "footbot_camera"
  std::string text;              ///< "footbot_camera: more than 128 blobs"
  std::uint64_t first_tick = 0;  ///< as Space::tick counts
  std::uint64_t readings = 0;    ///< that were cut short, one a tick at the most
};

/// The place of a device in the list, where it is put if it is not there yet. Allocates then, so a sensor asks once,
/// when it first overflows. A robot that was deleted and spawned again has the place that it had.
inline std::size_t overflowOf(std::vector<Overflow>& overflows, const std::string& robot, const std::string& device) {
  const auto found = std::find_if(overflows.begin(), overflows.end(), [&](const Overflow& overflow) {
    return overflow.robot == robot && overflow.device == device;
  });
  const auto place = static_cast<std::size_t>(found - overflows.begin());
  if (found == overflows.end()) {
    Overflow& added = overflows.emplace_back();
    added.robot = robot;
    added.device = device;
  }
  return place;
}

}  // namespace swarmanoid
