#include "read_bag.hpp"

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <tuple>

#include "swarmanoid_hosts/ros/frame_messages.hpp"
#include "swarmanoid_interface/read_file.hpp"

namespace swarmanoid::replay {
namespace {

constexpr const char* kStart = "/controller/start";
constexpr const char* kSensors = "/controller/sensors";
constexpr const char* kCommands = "/controller/commands";

template <class Message>
struct Received {
  ros::Time time;
  typename Message::ConstPtr message;
};

/// All messages of one robot in the bag; within each topic in the order in which they were received.
struct Raw {
  std::vector<Received<swarmanoid_msgs::ControllerStart>> starts;
  std::vector<Received<swarmanoid_msgs::SensorFrame>> sensors;
  std::vector<Received<swarmanoid_msgs::CommandFrame>> commands;
};

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

template <class Message>
void add(const rosbag::MessageInstance& instance, std::vector<Received<Message>>& out) {
  const auto message = instance.instantiate<Message>();
  if (message == nullptr) {
    throw ConfigError({instance.getTopic(), 0}, "found " + instance.getDataType() + " (" + instance.getMD5Sum() +
                                                    "), allowed: " + ros::message_traits::datatype<Message>() + " (" +
                                                    ros::message_traits::md5sum<Message>() +
                                                    "); record and replay with the same version");
  }
  out.push_back({instance.getTime(), message});
}

std::map<std::string, Raw> readRaw(const std::string& file) {
  std::map<std::string, Raw> robots;
  try {
    rosbag::Bag bag(file, rosbag::bagmode::Read);
    for (const rosbag::MessageInstance& instance : rosbag::View(bag)) {
      const std::string& topic = instance.getTopic();
      for (const std::string end : {kStart, kSensors, kCommands}) {
        if (!endsWith(topic, end)) {
          continue;
        }
        Raw& robot = robots[topic.substr(1, topic.size() - end.size() - 1)];
        if (end == kStart) {
          add(instance, robot.starts);
        } else if (end == kSensors) {
          add(instance, robot.sensors);
        } else {
          add(instance, robot.commands);
        }
      }
    }
  } catch (const rosbag::BagException& error) {
    throw ConfigError({file, 0}, std::string("cannot be read: ") + error.what());
  }
  if (robots.empty()) {
    throw ConfigError({file, 0},
                      "found no recorded controller, expected topics such as /fb_1/controller/sensors; the simulator "
                      "writes them with --record-controllers or record_controllers:=");
  }
  return robots;
}

void replace(const ParameterValue& parameter, swarmanoid_msgs::RemoteRobot& robot) {
  const auto slash = parameter.name.rfind('/');
  const std::string family = slash == std::string::npos ? "" : parameter.name.substr(0, slash + 1);
  auto place = robot.parameters.end();
  for (auto i = robot.parameters.begin(); i != robot.parameters.end(); ++i) {
    if (i->name == parameter.name) {
      i->value = parameter.value;
      return;
    }
    if (i->name.compare(0, family.size(), family) == 0) {
      place = i + 1;  // nested parameters are contiguous
    }
  }
  swarmanoid_msgs::TextParameter message;
  message.name = parameter.name;
  message.value = parameter.value;
  robot.parameters.insert(place, message);
}

/// Returns the run of a frame: the last start of the same run number that was received before it. A recorder that
/// starts later may receive a latched start a little after the first frames; then these belong to the first start.
RecordedRun* runOf(const Received<swarmanoid_msgs::SensorFrame>& frame,
                   const std::vector<Received<swarmanoid_msgs::ControllerStart>>& starts,
                   std::vector<RecordedRun>& runs) {
  RecordedRun* found = nullptr;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (starts[i].message->run == frame.message->run && (found == nullptr || starts[i].time <= frame.time)) {
      found = &runs[i];
    }
  }
  return found;
}

using TickKey = std::pair<std::uint64_t, std::uint64_t>;  // run and tick

/// Returns the commands of that tick that were received nearest to the readings, since the tick numbers of a restarted
/// robot repeat.
std::optional<CommandFrame> commandsOf(
    const Received<swarmanoid_msgs::SensorFrame>& sensors,
    const std::multimap<TickKey, const Received<swarmanoid_msgs::CommandFrame>*>& all) {
  const auto [begin, end] = all.equal_range({sensors.message->run, sensors.message->tick});
  const auto distance = [&](const auto& entry) { return std::abs((entry.second->time - sensors.time).toSec()); };
  const auto nearest =
      std::min_element(begin, end, [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  if (nearest == end) {
    return std::nullopt;
  }
  return fromMessage(*nearest->second->message);
}

std::vector<RecordedRun> assemble(const std::string& file, const std::string& name, const Raw& raw,
                                  const std::vector<ParameterValue>& parameters) {
  ParameterLocations locations;
  for (const ParameterValue& parameter : parameters) {
    locations[parameter.name] = parameter.location;  // the last parameter of a name gives its value and location
  }
  std::vector<RecordedRun> runs;
  for (const auto& received : raw.starts) {
    swarmanoid_msgs::ControllerStart start = *received.message;
    for (const ParameterValue& parameter : parameters) {
      replace(parameter, start.robot);
    }
    runs.push_back({fromMessage(start, locations), Time(Duration(start.header.stamp.toNSec())), {}});
  }
  std::multimap<TickKey, const Received<swarmanoid_msgs::CommandFrame>*> commands;
  for (const auto& received : raw.commands) {
    commands.emplace(TickKey{received.message->run, received.message->tick}, &received);
  }
  for (const auto& received : raw.sensors) {
    SensorFrame frame = fromMessage(*received.message);
    RecordedRun* run = runOf(received, raw.starts, runs);
    if (run == nullptr) {
      throw ConfigError({file, 0}, "'" + name + "': found no /" + name + kStart + " of run " +
                                       std::to_string(frame.stamp.run) + "; record that topic too");
    }
    if (!run->ticks.empty() && run->ticks.back().sensors.stamp == frame.stamp) {
      continue;  // a frame that was sent twice
    }
    run->ticks.push_back({std::move(frame), commandsOf(received, commands)});
  }
  return runs;
}

}  // namespace

Recording readBag(const std::string& file, const std::vector<std::string>& robots,
                  const std::vector<ParameterValue>& parameters) {
  const std::map<std::string, Raw> raw = readRaw(file);
  std::vector<std::string> known;
  for (const auto& [name, frames] : raw) {
    known.push_back(name);
  }
  Recording recording;
  for (const std::string& name : robots.empty() ? known : robots) {
    const auto found = raw.find(name);
    if (found == raw.end()) {
      throw ConfigError({file, 0}, "found no recorded controller of '" + name + "', there are: " + joinNames(known) +
                                       didYouMean(name, known));
    }
    recording[name] = assemble(file, name, found->second, parameters);
  }
  return recording;
}

std::vector<ParameterValue> readParameters(const std::string& word) {
  const auto equals = word.find('=');
  if (equals != std::string::npos && equals > 0) {
    const std::string name = word.substr(0, equals);
    return {{name, word.substr(equals + 1), {"--parameters " + name, 0}}};
  }
  std::error_code ignored;
  if (!std::filesystem::exists(word, ignored)) {
    throw ConfigError({"--parameters", 0}, "found '" + word + "', allowed: name=value, or a file that can be read");
  }
  constexpr std::size_t kLongestFile = 1'000'000;  // [bytes]
  std::istringstream in(readFile(word, kLongestFile));
  const auto trimmed = [](const std::string& text) {
    const char* const white = " \t\r";
    const auto first = text.find_first_not_of(white);
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(white) - first + 1);
  };
  std::vector<ParameterValue> values;
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    line = trimmed(line.substr(0, line.find('#')));
    if (line.empty()) {
      continue;
    }
    const auto colon = line.find(": ");
    if (colon == std::string::npos || colon == 0) {
      throw ConfigError({word, number},
                        "found '" + line + "', allowed: name: value (of nested ones outer/inner: value)");
    }
    values.push_back({trimmed(line.substr(0, colon)), trimmed(line.substr(colon + 1)), {word, number}});
  }
  return values;
}

}  // namespace swarmanoid::replay
