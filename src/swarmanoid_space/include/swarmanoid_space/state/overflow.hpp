/// Overflows: sensors with more in sight than they can report, and how often in a run, by device.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace swarmanoid {

/// The overflows of one device of one robot. The entry outlives its robot, since it qualifies the results of the run.
struct Overflow {
  std::string robot;
  std::string device;            ///< its type, such as "footbot_camera"
  std::string text;              ///< "footbot_camera: more than 128 blobs"
  std::uint64_t first_tick = 0;  ///< in the count of Space::tick
  std::uint64_t readings = 0;    ///< truncated readings, at most one per tick
};

/// The index of a device in the list; adds the device if it is missing. This allocates, so a sensor calls it once, on
/// its first overflow. A robot that was deleted and spawned again keeps its entry.
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
