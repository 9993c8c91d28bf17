#include "swarmanoid_hosts/robot_configuration.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace swarmanoid {
namespace {

const std::vector<std::string>& keys() {
  static const std::vector<std::string> keys{"robot_type",    "rate",     "seed",       "sensors",
                                             "actuators",     "topics",   "parameters", "sensor_timeout",
                                             "start_timeout", "safe_stop"};
  return keys;
}

Duration secondsToDuration(double seconds) {
  constexpr double kNanosecondsPerSecond = 1e9;
  return Duration(std::llround(seconds * kNanosecondsPerSecond));
}

/// Splits "a, b" into a and b.
std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> names;
  std::istringstream in(text);
  for (std::string name; std::getline(in, name, ',');) {
    const auto first = name.find_first_not_of(" \t\n");
    const auto last = name.find_last_not_of(" \t\n");
    names.push_back(first == std::string::npos ? "" : name.substr(first, last - first + 1));
  }
  return names;
}

/// Returns the robot types that devices name, in the order of the devices.
std::vector<std::string> robotTypesOf(const std::vector<KnownDevice>& known) {
  std::vector<std::string> types;
  for (const KnownDevice& device : known) {
    if (!device.robot.empty() && std::find(types.begin(), types.end(), device.robot) == types.end()) {
      types.push_back(device.robot);
    }
  }
  return types;
}

/// Refuses a robot type that no device names, unless all devices that are listed are for any robot.
void checkRobotType(const Configuration& values, const std::string& robot_type, const std::vector<KnownDevice>& known) {
  const std::vector<std::string> types = robotTypesOf(known);
  if (std::find(types.begin(), types.end(), robot_type) != types.end()) {
    return;
  }
  std::vector<std::string> listed = split(values.text("sensors"));
  const std::vector<std::string> actuators = split(values.text("actuators"));
  listed.insert(listed.end(), actuators.begin(), actuators.end());
  const bool has_devices_of_others = std::any_of(known.begin(), known.end(), [&](const KnownDevice& device) {
    return !device.robot.empty() && std::find(listed.begin(), listed.end(), device.type) != listed.end();
  });
  if (has_devices_of_others) {
    throw ConfigError(values.find("robot_type")->location(), "robot_type: found '" + robot_type + "', allowed: " +
                                                                 joinNames(types) + didYouMean(robot_type, types));
  }
}

std::vector<RobotConfiguration::Device> readDevices(const Configuration& values, const std::string& key,
                                                    const std::string& robot_type,
                                                    const std::vector<KnownDevice>& known) {
  std::vector<std::string> allowed;
  for (const KnownDevice& device : known) {
    if (device.is_sensor == (key == "sensors") && (device.robot.empty() || device.robot == robot_type)) {
      allowed.push_back(device.type);
    }
  }
  std::vector<RobotConfiguration::Device> devices;
  for (const std::string& type : split(values.text(key))) {
    const SourceLocation& location = values.find(key)->location();
    const auto same = [&](const auto& device) { return device.type == type; };
    if (std::find(allowed.begin(), allowed.end(), type) == allowed.end()) {
      throw ConfigError(location, key + ": found '" + type + "', allowed for a " + robot_type + ": " +
                                      joinNames(allowed) + didYouMean(type, allowed));
    }
    if (std::any_of(devices.begin(), devices.end(), same)) {
      throw ConfigError(location, key + ": '" + type + "' stands there twice");
    }
    devices.push_back({type, std::find_if(known.begin(), known.end(), same)->topics.front()});
  }
  return devices;
}

void chooseTopics(const Configuration& chosen, const std::vector<KnownDevice>& known,
                  std::vector<RobotConfiguration::Device>& devices) {
  for (RobotConfiguration::Device& device : devices) {
    const Configuration* choice = chosen.find(device.type);
    if (choice == nullptr) {
      continue;
    }
    const auto entry =
        std::find_if(known.begin(), known.end(), [&](const KnownDevice& one) { return one.type == device.type; });
    device.topic = choice->text();
    if (std::find(entry->topics.begin(), entry->topics.end(), device.topic) == entry->topics.end()) {
      throw ConfigError(choice->location(), device.type + ": found '" + device.topic + "', allowed: " +
                                                joinNames(entry->topics) + didYouMean(device.topic, entry->topics));
    }
  }
}

void readTopics(const Configuration& values, const std::vector<KnownDevice>& known, RobotConfiguration& result) {
  const Configuration* chosen = values.find("topics");
  if (chosen == nullptr) {
    return;
  }
  std::vector<std::string> listed;
  for (auto* devices : {&result.sensors, &result.actuators}) {
    chooseTopics(*chosen, known, *devices);
    for (const RobotConfiguration::Device& device : *devices) {
      listed.push_back(device.type);
    }
  }
  chosen->refuseUnread(listed);
}

SafeStopSettings readSafeStop(const Configuration& values) {
  SafeStopSettings settings;
  if (const Configuration* stop = values.find("safe_stop")) {
    constexpr Range kTime{0.0, 3600.0};
    settings.hover = stop->number("hover", settings.hover, kTime);
    settings.descend_speed = stop->number("descend_speed", settings.descend_speed, {0.0, 5.0});
    settings.descend_time = stop->number("descend_time", settings.descend_time, kTime);
    stop->refuseUnread({"hover", "descend_speed", "descend_time"});
  }
  return settings;
}

}  // namespace

RobotConfiguration readRobotConfiguration(const Configuration& values, const std::vector<KnownDevice>& known) {
  RobotConfiguration result;
  result.robot_type = values.text("robot_type");
  checkRobotType(values, result.robot_type, known);
  constexpr double kRate = 10.0;  // [Hz]
  constexpr Range kTimeout{0.01, 3600.0};
  result.period = secondsToDuration(1.0 / values.number("rate", kRate, {0.1, 1000.0}));
  result.seed = static_cast<std::uint64_t>(values.integer("seed", std::int64_t{1}, {0.0, kInfinity}));
  result.sensors = readDevices(values, "sensors", result.robot_type, known);
  result.actuators = readDevices(values, "actuators", result.robot_type, known);
  readTopics(values, known, result);
  const Configuration* parameters = values.find("parameters");
  result.parameters = parameters != nullptr ? *parameters : Configuration("parameters", "", values.location());
  result.sensor_timeout = secondsToDuration(values.number("sensor_timeout", 0.5, kTimeout));
  result.start_timeout = secondsToDuration(values.number("start_timeout", 10.0, kTimeout));
  result.safe_stop = readSafeStop(values);
  values.refuseUnread(keys());
  return result;
}

}  // namespace swarmanoid
