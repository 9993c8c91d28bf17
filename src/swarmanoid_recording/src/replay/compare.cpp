#include "compare.hpp"

#include <algorithm>

#include "device_values.hpp"
#include "swarmanoid_interface/frame_parts.hpp"
#include "swarmanoid_interface/step_controller.hpp"

namespace swarmanoid::replay {
namespace {

std::vector<Bytes> readBlocks(ByteReader& in, std::size_t count) {
  std::vector<Bytes> blocks;
  for (std::size_t i = 0; i < count; ++i) {
    ByteReader block = in.block();
    Bytes& bytes = blocks.emplace_back();
    while (block.left() > 0) {
      bytes.push_back(block.number<std::uint8_t>());
    }
  }
  return blocks;
}

void refuseRest(const ByteReader& in) {
  if (in.left() > 0) {
    throw ByteError("found " + std::to_string(in.left()) + " bytes more than expected");
  }
}

/// Returns whether a command has a number that is not finite. The space stops a robot with such a command; the
/// controller itself gets no error.
bool commandsNoNumber(const Answer& answer, const RemoteRobot& robot) {
  for (std::size_t i = 0; i < answer.commands.size(); ++i) {
    if (!isFinite(decode(robot.actuators[i].layout, answer.commands[i]))) {
      return true;
    }
  }
  return false;
}

}  // namespace

Answer answerOf(const CommandFrame& frame, const RemoteRobot& robot) {
  ByteReader in(frame.data);
  Answer answer;
  answer.status = static_cast<StepStatus>(in.number<std::uint8_t>());
  switch (answer.status) {
    case StepStatus::kNothing:
      break;
    case StepStatus::kFailed:
      answer.failure = in.text();
      break;
    case StepStatus::kStepped: {
      answer.commands = readBlocks(in, robot.actuators.size());
      answer.debug = readDebugValues(in);
      break;
    }
    default:
      throw ByteError("found the status " + std::to_string(static_cast<int>(answer.status)) + ", allowed: 0 to 2");
  }
  refuseRest(in);
  return answer;
}

std::vector<Bytes> readingsOf(const SensorFrame& frame, const RemoteRobot& robot) {
  ByteReader in(frame.data);
  const bool is_present = in.number<std::uint8_t>() != 0;
  std::vector<Bytes> readings = readBlocks(in, is_present ? robot.sensors.size() : 0);
  refuseRest(in);
  return readings;
}

bool isSame(const Answer& recorded, const Answer& replayed, const RemoteRobot& robot) {
  if (recorded.status == StepStatus::kFailed && recorded.failure == kNotFinite &&
      replayed.status == StepStatus::kStepped) {
    return commandsNoNumber(replayed, robot);
  }
  return recorded.status == replayed.status && recorded.failure == replayed.failure &&
         recorded.commands == replayed.commands;
}

Comparison compare(const RecordedRun& run, ControllerHost::Factory make, Robot::LogSink log, TickRange range) {
  ControllerHost host(run.start, std::move(make), std::move(log));
  Comparison result;
  for (const RecordedTick& tick : run.ticks) {
    if (tick.sensors.stamp.tick > range.last) {
      break;
    }
    try {
      Answer replayed = answerOf(host.answer(tick.sensors), run.robot());
      if (!range.contains(tick.sensors.stamp.tick)) {
        continue;
      }
      if (!tick.commands) {
        ++result.without_commands;
        continue;
      }
      Answer recorded = answerOf(*tick.commands, run.robot());
      ++result.compared;
      if (isSame(recorded, replayed, run.robot())) {
        ++result.equal;
      } else if (!result.first) {
        result.first = Difference{tick.sensors, std::move(recorded), std::move(replayed)};
      }
    } catch (const ByteError& error) {
      throw ByteError(run.robot().name + ", tick " + std::to_string(tick.sensors.stamp.tick) + ": " + error.what());
    }
  }
  return result;
}

}  // namespace swarmanoid::replay
