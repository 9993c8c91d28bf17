/// The configuration of a robot's host: the devices of its controller and their topics, the rate, and the conditions of
/// the safe stop. On a robot this is a YAML file (docs/how-to/run_on_a_robot.md); here it is a Configuration, from any
/// source.
///
///     robot_type: footbot                       a type that devices name; or any, if all devices are for any robot
///     rate: 10                                  of the controller [Hz], 0.1 to 1000
///     seed: 1                                   of robot.random()
///     sensors: [footbot_proximity]              device types
///     actuators: [footbot_wheels]
///     topics: {footbot_wheels: cmd_vel}         for a device with several; default: the first
///     parameters: {speed: 0.1}                  of the controller
///     sensor_timeout: 0.5                       a sensor without messages for longer is lost [s]
///     start_timeout: 10                         limit of the wait for all devices [s]
///     safe_stop: {hover: 2, descend_speed: 0.3, descend_time: 8}   of an eyebot [s, m/s, s]
///
/// Robot type, sensors and actuators must be given; the others have the values above, no topics and no parameters.
#pragma once

#include <string>
#include <vector>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/safe_stop.hpp"
#include "swarmanoid_interface/time.hpp"

namespace swarmanoid {

/// A device type that has topics in this process.
struct KnownDevice {
  std::string type;
  bool is_sensor = false;
  std::string robot;                ///< only robots of this type have the device; "": any
  std::vector<std::string> topics;  ///< the first is the main topic
};

struct RobotConfiguration {
  struct Device {
    std::string type;
    std::string topic;  ///< topic in the robot's namespace
  };

  std::string robot_type;
  Duration period{};
  std::uint64_t seed = 1;
  std::vector<Device> sensors;
  std::vector<Device> actuators;
  Configuration parameters;
  Duration sensor_timeout{};
  Duration start_timeout{};
  SafeStopSettings safe_stop;
};

/// @throws ConfigError with the value's location, the value found and the allowed values; also for unknown names
RobotConfiguration readRobotConfiguration(const Configuration& values, const std::vector<KnownDevice>& known);

}  // namespace swarmanoid
