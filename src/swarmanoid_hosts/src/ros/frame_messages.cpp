#include "swarmanoid_hosts/ros/frame_messages.hpp"

#include "swarmanoid_hosts/ros/device_messages.hpp"

namespace swarmanoid {
namespace {

template <class Message>
FrameStamp stampOf(const Message& message) {
  return {message.session, message.run, message.tick};
}

template <class Message>
void setStamp(const FrameStamp& stamp, Message& message) {
  message.session = stamp.session;
  message.run = stamp.run;
  message.tick = stamp.tick;
}

std::vector<swarmanoid_msgs::DeviceLayout> toMessages(const std::vector<DeviceLayout>& devices) {
  std::vector<swarmanoid_msgs::DeviceLayout> messages;
  for (const DeviceLayout& device : devices) {
    messages.emplace_back();
    messages.back().type = device.type;
    messages.back().layout = device.layout;
    messages.back().names = device.names;
  }
  return messages;
}

std::vector<DeviceLayout> fromMessages(const std::vector<swarmanoid_msgs::DeviceLayout>& messages) {
  std::vector<DeviceLayout> devices;
  for (const auto& message : messages) {
    devices.push_back({message.type, message.layout, message.names});
  }
  return devices;
}

/// Writes the text of "outer/inner" for every element that has a text or no children.
void flatten(const Configuration& element, const std::string& path, swarmanoid_msgs::RemoteRobot& message) {
  for (const Configuration& child : element.children()) {
    const std::string child_path = path + child.name();
    if (!child.text().empty() || child.children().empty()) {
      message.parameters.emplace_back();
      message.parameters.back().name = child_path;
      message.parameters.back().value = child.text();
    }
    flatten(child, child_path + "/", message);
  }
}

/// Does the inverse. An element comes before its children, and its children come before the next element.
void unflatten(const std::string& path, const std::string& value, const SourceLocation& location,
               Configuration& element) {
  const auto slash = path.find('/');
  if (slash == std::string::npos) {
    element.add(Configuration(path, value, location));
    return;
  }
  const std::string name = path.substr(0, slash);
  const bool is_last = !element.children().empty() && element.children().back().name() == name;
  Configuration inner = is_last ? element.children().back() : Configuration(name, "", location);
  unflatten(path.substr(slash + 1), value, location, inner);
  if (!is_last) {
    element.add(std::move(inner));
    return;
  }
  Configuration changed(element.name(), element.text(), element.location());
  for (std::size_t i = 0; i + 1 < element.children().size(); ++i) {
    changed.add(element.children()[i]);
  }
  changed.add(std::move(inner));
  element = std::move(changed);
}

void toMessage(const RemoteRobot& robot, swarmanoid_msgs::RemoteRobot& message) {
  message.name = robot.name;
  message.type = robot.type;
  message.controller = robot.controller;
  message.label = robot.label;
  message.sensors = toMessages(robot.sensors);
  message.actuators = toMessages(robot.actuators);
  message.parameters.clear();
  message.location = robot.parameters.location().toString();
  flatten(robot.parameters, "", message);
}

RemoteRobot fromMessage(const swarmanoid_msgs::RemoteRobot& message, const ParameterLocations& elsewhere) {
  const SourceLocation location{message.location, 0};  // the text contains the lines already
  Configuration parameters("parameters", "", location);
  for (const auto& parameter : message.parameters) {
    const auto place = elsewhere.find(parameter.name);
    unflatten(parameter.name, parameter.value, place == elsewhere.end() ? location : place->second, parameters);
  }
  return {message.name,
          message.type,
          message.controller,
          message.label,
          fromMessages(message.sensors),
          fromMessages(message.actuators),
          std::move(parameters)};
}

}  // namespace

void toMessage(const SensorFrame& frame, swarmanoid_msgs::SensorFrame& message) {
  setStamp(frame.stamp, message);
  message.seed = frame.seed;
  message.stamp = toRosTime(frame.time);
  message.clocktick.fromNSec(frame.clocktick.count());
  message.data = frame.data;
}

SensorFrame fromMessage(const swarmanoid_msgs::SensorFrame& message) {
  SensorFrame frame;
  frame.stamp = stampOf(message);
  frame.seed = message.seed;
  frame.time = Time(Duration(message.stamp.toNSec()));
  frame.clocktick = Duration(message.clocktick.toNSec());
  frame.data = message.data;
  return frame;
}

void toMessage(const CommandFrame& frame, swarmanoid_msgs::CommandFrame& message) {
  setStamp(frame.stamp, message);
  message.data = frame.data;
}

CommandFrame fromMessage(const swarmanoid_msgs::CommandFrame& message) { return {stampOf(message), message.data}; }

void toMessage(const Registration& registration, swarmanoid_msgs::Register::Response& message) {
  message.session = registration.session;
  message.run = registration.run;
  message.tick = registration.tick;
  message.seed = registration.seed;
  message.clocktick.fromNSec(registration.clocktick.count());
  for (const RemoteRobot& robot : registration.robots) {
    toMessage(robot, message.robots.emplace_back());
  }
}

Registration fromMessage(const swarmanoid_msgs::Register::Response& message) {
  Registration registration;
  registration.session = message.session;
  registration.run = message.run;
  registration.tick = message.tick;
  registration.seed = message.seed;
  registration.clocktick = Duration(message.clocktick.toNSec());
  for (const auto& sent : message.robots) {
    registration.robots.push_back(fromMessage(sent, {}));
  }
  return registration;
}

void toMessage(const Registration& registration, std::size_t robot, swarmanoid_msgs::ControllerStart& message) {
  toMessage(registration.robots[robot], message.robot);
  message.seed = registration.seed;
  message.run = registration.run;
  message.clocktick.fromNSec(registration.clocktick.count());
}

Registration fromMessage(const swarmanoid_msgs::ControllerStart& message, const ParameterLocations& elsewhere) {
  Registration registration;
  registration.run = message.run;
  registration.seed = message.seed;
  registration.clocktick = Duration(message.clocktick.toNSec());
  registration.robots.push_back(fromMessage(message.robot, elsewhere));
  return registration;
}

}  // namespace swarmanoid
