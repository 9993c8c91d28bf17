#include "mock_robot.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace swarmanoid::mock {
namespace {

std::map<std::string, MakeMockDevice>& mockDevices() {
  static std::map<std::string, MakeMockDevice> makers;
  return makers;
}

std::vector<std::string> namesOf(const std::vector<const DeviceType*>& types) {
  std::vector<std::string> names;
  for (const DeviceType* type : types) {
    names.push_back(type->type);
  }
  return names;
}

}  // namespace

MakeMockDevice findMockDevice(const std::string& type) {
  const auto found = mockDevices().find(type);
  return found == mockDevices().end() ? nullptr : found->second;
}

MockDeviceRegistration::MockDeviceRegistration(const std::string& type, MakeMockDevice make) {
  mockDevices().emplace(type, make);
}

MockRobot::MockRobot(const std::vector<std::string>& devices, const World& world) {
  state_.world = world;
  for (const std::string& name : std::set<std::string>(devices.begin(), devices.end())) {
    const DeviceType* type = findDeviceType(name);
    devices_.push_back({type, type->make(), nullptr});
    if (const MakeMockDevice make = findMockDevice(name)) {
      devices_.back().mock = make(devices_.back().value.get(), state_);
    }
  }
  sense();
}

void MockRobot::advance(double dt) {
  for (Device& device : devices_) {
    if (device.mock) {
      device.mock->act(state_, dt);
    }
  }
  state_.move(dt);
  for (Device& device : devices_) {
    if (device.mock) {
      device.mock->follow(state_);
    }
  }
  sense();
}

void MockRobot::place(const Pose& pose) {
  state_.pose = pose;
  sense();
}

const MockRobot::Device* MockRobot::find(const std::string& type) const {
  const auto found =
      std::find_if(devices_.begin(), devices_.end(), [&](const Device& device) { return device.type->type == type; });
  return found == devices_.end() ? nullptr : &*found;
}

void MockRobot::sense() {
  for (Device& device : devices_) {
    if (device.mock) {
      device.mock->sense(state_);
    }
  }
}

std::vector<std::string> devicesOf(const std::string& robot_type, const std::vector<std::string>& others,
                                   const SourceLocation& location) {
  std::vector<std::string> devices;
  for (const DeviceType* type : deviceTypes()) {
    if (!robot_type.empty() && type->robot == robot_type) {
      devices.push_back(type->type);
    }
  }
  for (const std::string& name : others) {
    if (findDeviceType(name) == nullptr) {
      const std::vector<std::string> known = namesOf(deviceTypes());
      throw ConfigError(location,
                        "devices: found '" + name + "', allowed: " + joinNames(known) + didYouMean(name, known));
    }
    devices.push_back(name);
  }
  if (devices.empty()) {
    const std::vector<std::string> types = robotTypesOfDevices();
    throw ConfigError(location, "type: found '" + robot_type + "', allowed: " + joinNames(types) +
                                    ", or any other type whose devices are named (devices)" +
                                    didYouMean(robot_type, types));
  }
  return devices;
}

std::unique_ptr<MockRobot> makeMockRobot(const std::vector<std::string>& devices, const Configuration& values) {
  auto robot = std::make_unique<MockRobot>(devices, readWorld(values));
  Pose start = robot->state().pose;
  start.position = values.vector3("start", start.position);
  start.yaw = values.angle("start_yaw", 0.0);
  values.refuseUnread({"walls", "beacons", "discs", "ceiling", "hands", "ring", "tags", "joints", "holders", "wheels",
                       "start", "start_yaw"});
  robot->place(start);
  return robot;
}

CommandWatchdog::CommandWatchdog(const MockRobot& robot, double timeout)
    : mock_(robot), robot_("mock", "mock", 0), timeout_(timeout), silence_(robot.devices().size(), kNever) {
  for (const MockRobot::Device& device : robot.devices()) {
    if (device.type->kind == DeviceKind::kSensor) {
      robot_.provideSensor(device.type->type, device.value.get());
    }
  }
}

void CommandWatchdog::advance(double dt) {
  for (std::size_t i = 0; i < silence_.size(); ++i) {
    if (silence_[i] < 0.0) {
      continue;
    }
    silence_[i] += dt;
    if (hasExpired(i)) {
      const MockRobot::Device& actuator = mock_.devices()[i];
      actuator.type->stop(actuator.value.get(), {silence_[i] - timeout_, {}, robot_});
    }
  }
}

}  // namespace swarmanoid::mock
