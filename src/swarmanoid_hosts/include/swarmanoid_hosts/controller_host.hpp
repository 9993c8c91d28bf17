/// Runs controllers without a space in the same process: a sensor frame is the input, a command frame the output.
///
/// The controllers get the same input as in the space's process, to the last bit: their robots' names, the seed, the
/// time and the readings are the same. When the space is reset, or a robot returns, its controller is restarted.
///
/// Threads  all functions are called from one thread.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/frames.hpp"
#include "swarmanoid_interface/process/user_code.hpp"

namespace swarmanoid {

class ControllerHost {
 public:
  using Factory = std::function<std::shared_ptr<Controller>()>;

  /// Makes all controllers.
  /// @throws std::runtime_error for a device that is not registered in this process, or has other fields in it
  /// @throws the exception of a controller's init
  ControllerHost(Registration registration, Factory make, Robot::LogSink log);
  ~ControllerHost();
  ControllerHost(const ControllerHost&) = delete;
  ControllerHost& operator=(const ControllerHost&) = delete;

  /// Steps the controllers of all robots that are present. A repeated frame gets the same answer and steps no
  /// controller.
  /// @throws ByteError for a frame that does not fit the registration; then no controller was stepped
  const CommandFrame& answer(const SensorFrame& frame);

 private:
  struct Device {
    const DeviceType* type = nullptr;
    std::shared_ptr<void> data;
    VariableParts parts;
  };
  struct Hosted {
    std::unique_ptr<Robot> robot;  // null: the robot is not present
    std::vector<Device> sensors;
    std::vector<Device> actuators;
    std::shared_ptr<Controller> controller;
    std::string part;  // the controller's, as UserCode has it
    UserCode step;     // the call of the controller's step
    std::string failure;
    bool is_present = false;
  };

  void give(Hosted& hosted, const RemoteRobot& description);
  void take(Hosted& hosted);
  void read(const SensorFrame& frame);
  void write(const Hosted& hosted, ByteWriter& out) const;

  Registration registration_;
  Factory make_;
  Robot::LogSink log_;
  std::uint64_t run_;
  std::uint64_t seed_;
  std::vector<Hosted> hosted_;  // in the order of registration_.robots
  CommandFrame answer_;
  bool has_answered_ = false;
};

}  // namespace swarmanoid
