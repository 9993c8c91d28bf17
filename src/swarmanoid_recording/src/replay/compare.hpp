/// Passes recorded readings to a controller, and compares its commands with the recorded ones.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "recording.hpp"
#include "swarmanoid_hosts/controller_host.hpp"

namespace swarmanoid::replay {

/// The result of a controller's step in a tick, read from its command frame.
struct Answer {
  StepStatus status = StepStatus::kNothing;
  std::string failure;
  std::vector<Bytes> commands;  ///< bytes of each actuator, in the order of the robot's description
  std::vector<std::pair<std::string, std::string>> debug;
};

/// @throws ByteError if the frame is not one of that robot
Answer answerOf(const CommandFrame& frame, const RemoteRobot& robot);

/// Returns the readings of each sensor, in the order of the robot's description; none if the controller was not
/// stepped.
/// @throws ByteError if the frame is not one of that robot
std::vector<Bytes> readingsOf(const SensorFrame& frame, const RemoteRobot& robot);

struct TickRange {
  std::uint64_t first = 0;
  std::uint64_t last = std::numeric_limits<std::uint64_t>::max();

  bool contains(std::uint64_t tick) const { return tick >= first && tick <= last; }
};

/// A tick in which the controller's result differs.
struct Difference {
  SensorFrame sensors;
  Answer recorded;
  Answer replayed;
};

struct Comparison {
  std::size_t compared = 0;
  std::size_t equal = 0;
  std::size_t without_commands = 0;  ///< ticks without recorded commands
  std::optional<Difference> first;
};

/// Returns whether both have the same commands, byte by byte, or failed for the same reason. Debug values are not
/// compared.
bool isSame(const Answer& recorded, const Answer& replayed, const RemoteRobot& robot);

/// Steps the controller through all recorded ticks up to the last of the range; those in the range are compared.
/// @throws std::runtime_error if its devices have other fields in this process @throws ByteError for a bad frame
/// @throws the exception of a controller's init
Comparison compare(const RecordedRun& run, ControllerHost::Factory make, Robot::LogSink log, TickRange range = {});

}  // namespace swarmanoid::replay
