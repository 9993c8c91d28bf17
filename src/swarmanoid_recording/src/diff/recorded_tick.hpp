/// The recorded data of one tick in a bag: input and output of controllers, and the state of the space at its end.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "swarmanoid_interface/frames.hpp"

namespace swarmanoid::diff {

/// Fields of a space's state: numbers first, then texts.
struct StateFields {
  std::shared_ptr<const std::vector<std::string>> names;  ///< "fb_1/pose/position/x"; of numbers, then of texts
  std::vector<double> numbers;
  std::vector<std::string> texts;
};

/// The frames of one robot; a missing one was not recorded in that tick.
struct ControllerFrames {
  std::optional<SensorFrame> sensors;
  std::optional<CommandFrame> commands;
};

/// Identifies a tick of a run. The number counts finished ticks, so 0 is the state before the first.
struct TickKey {
  std::uint64_t run = 0;
  std::uint64_t finished_ticks = 0;

  friend bool operator<(const TickKey& a, const TickKey& b) {
    return a.run != b.run ? a.run < b.run : a.finished_ticks < b.finished_ticks;
  }
};

struct RecordedTick {
  TickKey key;
  std::map<std::string, ControllerFrames> controllers;  ///< by robot
  std::optional<StateFields> state;
};

/// Maps a robot to the description in its last start.
using RobotDescriptions = std::map<std::string, RemoteRobot>;

}  // namespace swarmanoid::diff
