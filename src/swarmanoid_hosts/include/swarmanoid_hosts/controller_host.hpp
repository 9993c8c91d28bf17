/// Runs controllers without a space in the same process: a sensor frame in, a command frame out.
///
/// The controllers see what they would see in the space's process, to the last bit: their robots' names, the seed, the
/// time and the readings are the same. When the space is reset, or a robot comes back, its controller starts anew.
///
/// Threads  all functions from one thread.
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
  /// @throws std::runtime_error for a device that is not known here, or has other fields here
  /// @throws what a controller's init throws
  ControllerHost(Registration registration, Factory make, Robot::LogSink log);
  ~ControllerHost();
  ControllerHost(const ControllerHost&) = delete;
  ControllerHost& operator=(const ControllerHost&) = delete;

  /// Steps the controllers of all robots that are present. The same frame again gets the same answer and steps nobody.
  /// @throws ByteError for a frame that does not fit the registration; then nobody was stepped
  const CommandFrame& answer(const SensorFrame& frame);

 private:
  struct Device {
    const DeviceType* type = nullptr;
    std::shared_ptr<void> data;
    VariableParts parts;
  };
  struct Hosted {
    std::unique_ptr<Robot> robot;  // null: not present
    std::vector<Device> sensors;
    std::vector<Device> actuators;
    std::shared_ptr<Controller> controller;
    std::string part;  // of it, as UserCode has it
    UserCode step;     // of it
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
  std::vector<Hosted> hosted_;  // as registration_.robots
  CommandFrame answer_;
  bool has_answered_ = false;
};

}  // namespace swarmanoid
