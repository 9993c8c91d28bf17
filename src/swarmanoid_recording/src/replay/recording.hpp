/// The recorded data of controllers: for each robot its starts, and the frames of each tick after them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "swarmanoid_interface/frames.hpp"

namespace swarmanoid::replay {

struct RecordedTick {
  SensorFrame sensors;
  std::optional<CommandFrame> commands;  ///< empty if the recording lacks them
};

/// One run of a controller, from its start to its end.
struct RecordedRun {
  Registration start;               ///< registration of the one robot
  Time start_time = kEpoch;         ///< start in the controller's time
  std::vector<RecordedTick> ticks;  ///< in the order of the recording

  const RemoteRobot& robot() const { return start.robots.front(); }
};

/// Maps a robot's name to its runs.
using Recording = std::map<std::string, std::vector<RecordedRun>>;

}  // namespace swarmanoid::replay
