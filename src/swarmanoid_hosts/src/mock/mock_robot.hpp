/// Simulates a robot by simple kinematics behind the devices of a real one, without ROS. Mock robots serve to try
/// controllers and hosts, not for experiments: no body has mass, no bodies collide, readings have no noise.
///
/// A robot consists of its devices (mock_device.hpp) and a state that they share (mock_state.hpp).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "mock_device.hpp"
#include "mock_state.hpp"
#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/robot.hpp"
#include "swarmanoid_interface/safe_stop.hpp"

namespace swarmanoid::mock {

class MockRobot {
 public:
  struct Device {
    const DeviceType* type;
    std::shared_ptr<void> value;       ///< the device's struct: readings, or the command
    std::unique_ptr<MockDevice> mock;  ///< null: generic
  };

  /// @param devices types, which are registered
  MockRobot(const std::vector<std::string>& devices, const World& world);

  /// Carries out the commands for `dt` seconds, then reads the sensors.
  void advance(double dt);
  /// Puts the robot somewhere, and reads the sensors.
  void place(const Pose& pose);

  /// Returns the devices in the order of their types.
  const std::vector<Device>& devices() const { return devices_; }
  /// @return null if the robot has no such device
  const Device* find(const std::string& type) const;
  const MockState& state() const { return state_; }

 private:
  void sense();

  MockState state_;
  std::vector<Device> devices_;
};

/// Returns the devices of a mock robot of that type: those that only robots of that type have, and `others`. The type
/// "" has the others only.
/// @throws ConfigError at `location` for a device that is not known, and for a type without any device
std::vector<std::string> devicesOf(const std::string& robot_type, const std::vector<std::string>& others,
                                   const SourceLocation& location);

/// Reads the robot's world and its start from `values`: `start: [x, y, z]`, `start_yaw` [degrees], and the values of
/// readWorld. @throws ConfigError
std::unique_ptr<MockRobot> makeMockRobot(const std::vector<std::string>& devices, const Configuration& values);

/// The command watchdog of a driver: an actuator without a new command for `timeout` gets those of its safe stop until
/// the next command. Actuators that have had no command yet are not stopped.
class CommandWatchdog {
 public:
  /// @param timeout [s]
  CommandWatchdog(const MockRobot& robot, double timeout);

  /// @param device index in MockRobot::devices
  void commanded(std::size_t device) { silence_[device] = 0.0; }
  /// Call it before the robot moves. @param dt [s]
  void advance(double dt);
  /// Returns whether the last command is older than `timeout`, so that the actuator is being stopped.
  bool hasExpired(std::size_t device) const { return silence_[device] > timeout_; }

 private:
  static constexpr double kNever = -1.0;  // the device has had no command yet

  const MockRobot& mock_;
  Robot robot_;
  double timeout_;
  std::vector<double> silence_;  // [s]
};

}  // namespace swarmanoid::mock
