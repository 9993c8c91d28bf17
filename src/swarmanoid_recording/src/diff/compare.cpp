#include "compare.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <utility>

#include "../replay/compare.hpp"
#include "../replay/device_values.hpp"
#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid::diff {
namespace {

constexpr const char* kAbsent = "not recorded";

using Values = std::vector<std::pair<std::string, std::string>>;

std::string toText(double value) {
  char text[64];
  const auto [end, error] = std::to_chars(text, text + sizeof text, value);
  return std::string(text, end);
}

bool isSame(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

/// Compares lists with mostly equal names: first the values of each name in both lists, then those in only one.
void compareValues(const Values& first, const Values& second, std::vector<Difference>& out) {
  const std::map<std::string, std::string> others(second.begin(), second.end());
  std::set<std::string> seen;
  for (const auto& [name, value] : first) {
    const auto other = others.find(name);
    seen.insert(name);
    if (other == others.end()) {
      out.push_back({name, value, kAbsent});
    } else if (other->second != value) {
      out.push_back({name, value, other->second});
    }
  }
  for (const auto& [name, value] : second) {
    if (seen.count(name) == 0) {
      out.push_back({name, kAbsent, value});
    }
  }
}

Values valuesOf(const StateFields& state) {
  Values values;
  for (std::size_t i = 0; i < state.names->size(); ++i) {
    const std::size_t text = i - state.numbers.size();
    values.emplace_back((*state.names)[i],
                        i < state.numbers.size() ? toText(state.numbers[i] + 0.0) : "'" + state.texts[text] + "'");
  }
  return values;
}

void compareStates(const StateFields& first, const StateFields& second, std::vector<Difference>& out) {
  const bool have_same_names = first.names == second.names || *first.names == *second.names;
  if (have_same_names && first.texts == second.texts &&
      std::equal(first.numbers.begin(), first.numbers.end(), second.numbers.begin(), second.numbers.end(), isSame)) {
    return;
  }
  compareValues(valuesOf(first), valuesOf(second), out);
}

/// Returns the names of a robot's devices by type, and their values as far as the frame contains them.
Values devices(const std::string& begin, const std::vector<DeviceLayout>& types, const std::vector<Bytes>& blocks) {
  Values values;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    for (const auto& [field, number] : replay::named(replay::decode(types[i].layout, blocks[i]), types[i])) {
      values.emplace_back(begin + types[i].type + "/" + field, number);
    }
  }
  return values;
}

const RemoteRobot& describe(const std::string& robot, const RobotDescriptions& robots) {
  const auto found = robots.find(robot);
  if (found == robots.end()) {
    throw ConfigError({"/" + robot + "/controller/start", 0}, "found no message of that topic, expected one");
  }
  return found->second;
}

Values readings(const std::string& robot, const std::optional<SensorFrame>& frame, const RobotDescriptions& robots) {
  if (!frame) {
    return {};
  }
  const RemoteRobot& description = describe(robot, robots);
  return devices(robot + "/reading ", description.sensors, replay::readingsOf(*frame, description));
}

Values commands(const std::string& robot, const std::optional<CommandFrame>& frame, const RobotDescriptions& robots) {
  if (!frame) {
    return {};
  }
  const RemoteRobot& description = describe(robot, robots);
  const replay::Answer answer = replay::answerOf(*frame, description);
  Values values = devices(robot + "/command ", description.actuators, answer.commands);
  for (const auto& [name, value] : answer.debug) {
    values.emplace_back(robot + "/debug " + name, value);
  }
  if (answer.status == StepStatus::kFailed) {
    values.emplace_back(robot + "/failure", answer.failure);
  }
  return values;
}

template <class Frame>
bool isSame(const std::optional<Frame>& first, const std::optional<Frame>& second) {
  return first.has_value() == second.has_value() && (!first || first->data == second->data);
}

/// @param read function that decodes a frame
template <class Frame, class Read>
void compareFrames(const std::string& robot, const std::optional<Frame>& first, const std::optional<Frame>& second,
                   const Side& first_side, const Side& second_side, Read read, std::vector<Difference>& out) {
  if (isSame(first, second)) {
    return;
  }
  const std::size_t before = out.size();
  try {
    compareValues(read(robot, first, first_side.robots), read(robot, second, second_side.robots), out);
  } catch (const ByteError& error) {
    throw ConfigError({robot, 0}, "found a frame that is none of the robot's: " + std::string(error.what()));
  }
  if (out.size() == before) {
    out.push_back({robot + "/frame", first ? "other bytes" : kAbsent, second ? "other bytes" : kAbsent});
  }
}

}  // namespace

std::vector<Difference> compare(const Side& first, const Side& second) {
  SWARMANOID_EXPECTS(!(first.tick.key < second.tick.key) && !(second.tick.key < first.tick.key));
  std::vector<Difference> out;
  std::map<std::string, std::pair<ControllerFrames, ControllerFrames>> robots;
  for (const auto& [robot, frames] : first.tick.controllers) {
    robots[robot].first = frames;
  }
  for (const auto& [robot, frames] : second.tick.controllers) {
    robots[robot].second = frames;
  }
  for (const auto& [robot, frames] : robots) {
    compareFrames(robot, frames.first.sensors, frames.second.sensors, first, second, readings, out);
  }
  for (const auto& [robot, frames] : robots) {
    compareFrames(robot, frames.first.commands, frames.second.commands, first, second, commands, out);
  }
  if (first.tick.state && second.tick.state) {
    compareStates(*first.tick.state, *second.tick.state, out);
  } else if (first.tick.state || second.tick.state) {
    out.push_back({"state", first.tick.state ? "recorded" : kAbsent, second.tick.state ? "recorded" : kAbsent});
  }
  return out;
}

}  // namespace swarmanoid::diff
