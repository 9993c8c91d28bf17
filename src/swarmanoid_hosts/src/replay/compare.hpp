/// Feeds a controller with recorded readings, and compares what it commands with what was recorded.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "recording.hpp"
#include "swarmanoid_hosts/controller_host.hpp"

namespace swarmanoid::replay {

/// What a controller did in a tick, read from its command frame.
struct Answer {
  StepStatus status = StepStatus::kNothing;
  std::string failure;
  std::vector<Bytes> commands;  ///< of each actuator, in the order of the robot's description
  std::vector<std::pair<std::string, std::string>> debug;
};

/// @throws ByteError if the frame is not one of that robot
Answer answerOf(const CommandFrame& frame, const RemoteRobot& robot);

/// The readings of each sensor, in the order of the robot's description; none if the controller was not to step.
/// @throws ByteError if the frame is not one of that robot
std::vector<Bytes> readingsOf(const SensorFrame& frame, const RemoteRobot& robot);

struct TickRange {
  std::uint64_t first = 0;
  std::uint64_t last = std::numeric_limits<std::uint64_t>::max();

  bool contains(std::uint64_t tick) const { return tick >= first && tick <= last; }
};

/// A tick in which the controller does otherwise.
struct Difference {
  SensorFrame sensors;
  Answer recorded;
  Answer replayed;
};

struct Comparison {
  std::size_t compared = 0;
  std::size_t equal = 0;
  std::size_t without_commands = 0;  ///< ticks of which no commands were recorded
  std::optional<Difference> first;
};

/// Whether both command the same, byte by byte, or failed for the same reason. Debug values are not compared.
bool isSame(const Answer& recorded, const Answer& replayed, const RemoteRobot& robot);

/// The controller steps through all recorded ticks up to the last of the range; those in the range are compared.
/// @throws std::runtime_error if its devices have other fields here @throws ByteError for a bad frame
/// @throws what a controller's init throws
Comparison compare(const RecordedRun& run, ControllerHost::Factory make, Robot::LogSink log, TickRange range = {});

}  // namespace swarmanoid::replay
