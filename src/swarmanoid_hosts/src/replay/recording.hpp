/// What was recorded of controllers: for each robot its starts, and the frames of each tick after them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "swarmanoid_interface/frames.hpp"

namespace swarmanoid::replay {

struct RecordedTick {
  SensorFrame sensors;
  std::optional<CommandFrame> commands;  ///< nothing: the recording lacks them
};

/// One life of a controller.
struct RecordedRun {
  Registration start;               ///< of the one robot
  Time start_time = kEpoch;         ///< by the controller's time
  std::vector<RecordedTick> ticks;  ///< as they were recorded

  const RemoteRobot& robot() const { return start.robots.front(); }
};

/// By robot.
using Recording = std::map<std::string, std::vector<RecordedRun>>;

}  // namespace swarmanoid::replay
