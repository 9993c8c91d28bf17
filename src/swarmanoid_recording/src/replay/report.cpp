#include "report.hpp"

#include <algorithm>
#include <cstdio>

#include "device_values.hpp"

namespace swarmanoid::replay {
namespace {

/// Returns the time since the start of the run [s].
std::string secondsOf(Time time) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", toSeconds(time - kEpoch));
  return text;
}

std::string statusOf(const Answer& answer) {
  switch (answer.status) {
    case StepStatus::kStepped:
      return "stepped";
    case StepStatus::kFailed:
      return "failed: " + answer.failure;
    case StepStatus::kNothing:
      break;
  }
  return "did nothing";
}

std::string both(const std::string& recorded, const std::string& replayed) {
  return "recorded " + recorded + ", replayed " + replayed + "\n";
}

std::string find(const std::vector<std::pair<std::string, std::string>>& values, const std::string& key) {
  const auto found = std::find_if(values.begin(), values.end(), [&](const auto& value) { return value.first == key; });
  return found == values.end() ? "nothing" : found->second;
}

/// Returns the keys of both: those of the first in their order, then those that only the second has.
std::vector<std::string> keysOf(const std::vector<std::pair<std::string, std::string>>& first,
                                const std::vector<std::pair<std::string, std::string>>& second) {
  std::vector<std::string> keys;
  for (const auto* values : {&first, &second}) {
    for (const auto& [key, value] : *values) {
      if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
        keys.push_back(key);
      }
    }
  }
  return keys;
}

std::string deviceDifferences(const RemoteRobot& robot, const Difference& difference) {
  std::string text;
  for (std::size_t i = 0; i < robot.actuators.size(); ++i) {
    if (difference.recorded.commands[i] == difference.replayed.commands[i]) {
      continue;
    }
    const DeviceLayout& device = robot.actuators[i];
    text += "  " + device.type + " (" + device.layout + ")\n";
    const auto recorded = named(decode(device.layout, difference.recorded.commands[i]), device);
    const auto replayed = named(decode(device.layout, difference.replayed.commands[i]), device);
    for (const std::string& field : keysOf(recorded, replayed)) {
      const std::string before = find(recorded, field);
      const std::string now = find(replayed, field);
      if (before != now) {
        text += "    " + field + ": " + both(before, now);
      }
    }
  }
  return text;
}

std::string devices(const std::vector<DeviceLayout>& types, const std::vector<Bytes>& blocks, const std::string& before,
                    const std::string& between) {
  std::string text;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    text += before + types[i].type + between + toText(decode(types[i].layout, blocks[i])) + "\n";
  }
  return text;
}

std::string debugValues(const Difference& difference) {
  std::string text;
  for (const std::string& key : keysOf(difference.recorded.debug, difference.replayed.debug)) {
    const std::string before = find(difference.recorded.debug, key);
    const std::string now = find(difference.replayed.debug, key);
    text += "    " + key + ": " + (before == now ? before + "\n" : both(before, now));
  }
  return text.empty() ? "" : "  debug values\n" + text;
}

}  // namespace

std::string titleOf(const std::vector<RecordedRun>& runs, std::size_t run) {
  const std::string& robot = runs[run].robot().name;
  return runs.size() == 1
             ? robot
             : robot + ", start " + std::to_string(run + 1) + " (run " + std::to_string(runs[run].start.run) + ")";
}

std::string report(const RecordedRun& run, const std::string& title, const Comparison& comparison) {
  const std::string count = std::to_string(comparison.compared);
  std::string text = title + ": " +
                     (comparison.equal == comparison.compared
                          ? "all " + count + " ticks are equal"
                          : std::to_string(comparison.equal) + " of " + count + " ticks are equal") +
                     (comparison.without_commands == 0
                          ? ""
                          : "; " + std::to_string(comparison.without_commands) + " more have no recorded commands") +
                     "\n";
  if (!comparison.first) {
    return text;
  }
  const Difference& difference = *comparison.first;
  text += "first difference: " + run.robot().name + ", tick " + std::to_string(difference.sensors.stamp.tick) + ", " +
          secondsOf(difference.sensors.time) + " s\n";
  const bool have_both_stepped =
      difference.recorded.status == StepStatus::kStepped && difference.replayed.status == StepStatus::kStepped;
  text += have_both_stepped
              ? deviceDifferences(run.robot(), difference)
              : "  the controller: " + both(statusOf(difference.recorded), statusOf(difference.replayed)) +
                    devices(run.robot().actuators, difference.replayed.commands, "    replayed ", ": ");
  const std::vector<Bytes> readings = readingsOf(difference.sensors, run.robot());
  text += readings.empty() ? "" : "  readings\n" + devices(run.robot().sensors, readings, "    ", ": ");
  return text + debugValues(difference);
}

std::string warnings(const RecordedRun& run, const std::string& title) {
  std::string text;
  const std::string begin = "warning: " + title + ": ";
  if (run.ticks.empty()) {
    return begin + "started, but no readings are recorded\n";
  }
  const SensorFrame& first = run.ticks.front().sensors;
  if (first.stamp.tick != 0 && first.time - run.start_time > run.start.clocktick) {
    text += begin + "the recording begins at tick " + std::to_string(first.stamp.tick) +
            ", after the controller's start; what it knew by then is missing\n";
  }
  for (std::size_t i = 1; i < run.ticks.size(); ++i) {
    const std::uint64_t before = run.ticks[i - 1].sensors.stamp.tick;
    const std::uint64_t now = run.ticks[i].sensors.stamp.tick;
    if (now > before + 1) {
      text += begin + "ticks " + std::to_string(before + 1) + " to " + std::to_string(now - 1) + " are missing\n";
    }
  }
  return text;
}

std::string tableHeader() { return "#robot\ttick\ttime [s]\tkind\tname\tvalues\n"; }

std::string table(const RecordedRun& run, TickRange range) {
  std::string text;
  const RemoteRobot& robot = run.robot();
  for (const RecordedTick& tick : run.ticks) {
    if (!range.contains(tick.sensors.stamp.tick)) {
      continue;
    }
    const std::string begin =
        robot.name + "\t" + std::to_string(tick.sensors.stamp.tick) + "\t" + secondsOf(tick.sensors.time) + "\t";
    text += devices(robot.sensors, readingsOf(tick.sensors, robot), begin + "reading\t", "\t");
    if (!tick.commands) {
      continue;
    }
    const Answer answer = answerOf(*tick.commands, robot);
    if (answer.status != StepStatus::kStepped) {
      text += begin + "controller\t\t" + statusOf(answer) + "\n";
    }
    text += devices(robot.actuators, answer.commands, begin + "command\t", "\t");
    for (const auto& [key, value] : answer.debug) {
      text += begin + "debug\t" + key + "\t" + value + "\n";
    }
  }
  return text;
}

}  // namespace swarmanoid::replay
