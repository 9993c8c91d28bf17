/// The frames between a space and a participant, a process that runs controllers for the space: one sensor frame and
/// one command frame a tick. This file does not use ROS; swarmanoid_msgs has the messages of the same names.
///
/// Data of a sensor frame: for each robot of the registration, in that order, one byte (1: present, 0: not to be
/// stepped, because the robot is deleted, has failed, or has another command source), and if present each of its
/// sensors as a block (device_type.hpp). Data of a command frame: for each robot one byte (0: not stepped, 1: stepped,
/// 2: its controller failed), then if stepped each of its actuators as a block, and its debug values: count, key,
/// value, ...; if failed the reason.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "swarmanoid_interface/byte_stream.hpp"
#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/time.hpp"

namespace swarmanoid {

/// The tick of a frame and the registration that it belongs to.
struct FrameStamp {
  std::uint64_t session = 0;  ///< of the registration
  std::uint64_t run = 0;
  std::uint64_t tick = 0;

  friend bool operator==(const FrameStamp& a, const FrameStamp& b) {
    return a.session == b.session && a.run == b.run && a.tick == b.tick;
  }
  friend bool operator!=(const FrameStamp& a, const FrameStamp& b) { return !(a == b); }
};

struct SensorFrame {
  FrameStamp stamp;
  std::uint64_t seed = 1;
  Time time = kEpoch;
  Duration clocktick{};
  Bytes data;
};

struct CommandFrame {
  FrameStamp stamp;
  Bytes data;
};

/// Result of a control step: the controller was not called or not in time, has written commands, or has thrown.
enum class StepStatus : std::uint8_t { kNothing = 0, kStepped = 1, kFailed = 2 };

/// A device of a robot, with the layout of its bytes.
struct DeviceLayout {
  std::string type;
  std::string layout;
  std::string names = {};  ///< of its fields, as fieldNames returns them; for processes without the device's struct
};

/// A robot that a participant commands.
struct RemoteRobot {
  std::string name;
  std::string type;
  std::string controller;  ///< id in the experiment
  std::string label;       ///< of that controller
  std::vector<DeviceLayout> sensors;
  std::vector<DeviceLayout> actuators;
  Configuration parameters;
};

/// The answer of a space to a participant.
struct Registration {
  std::uint64_t session = 0;
  std::uint64_t run = 0;
  std::uint64_t tick = 0;
  std::uint64_t seed = 1;
  Duration clocktick{};
  std::vector<RemoteRobot> robots;
};

}  // namespace swarmanoid
