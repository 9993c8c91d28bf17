/// One robot and its controller, period after period, without ROS: the caller, which has the robot's devices, passes
/// their readings and the time, and sends the commands when `tick` returns true.
///
///     waiting ----> running <----> stopped      all devices are present; sensors are lost; all are back
///        |             |              |
///        |             +--> ending <--+         the controller failed, or the end was requested
///        |                     |
///        +------> over <-------+                devices are missing at the start; the safe stop is done
///
/// While stopped and while ending, commands are those of the safe stop (safe_stop.hpp). While stopped the controller is
/// not stepped and its time does not advance; afterwards it continues without a reset. After a failure it never
/// continues.
///
/// Time     the controller's time is kEpoch at its first step and advances by whole periods, missed ones included; dt
///          is the time since its last step. `now` is the time of any steady clock.
/// Threads  all functions are called from one thread.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "swarmanoid_hosts/controller_host.hpp"
#include "swarmanoid_hosts/robot_configuration.hpp"

namespace swarmanoid {

class RobotLoop {
 public:
  enum class State { kWaiting, kRunning, kStopped, kEnding, kOver };
  /// The reason for the end.
  enum class End { kNone, kAsked, kFailed, kMissing };

  /// A device's struct, and the storage of its variable parts.
  struct Value {
    std::shared_ptr<void> data;
    VariableParts parts;
  };
  struct Sensor {
    RobotConfiguration::Device device;
    const DeviceType* type = nullptr;
    Value reading;                  ///< the caller writes to it
    std::optional<Duration> heard;  ///< time of the last reading
  };
  struct Actuator {
    RobotConfiguration::Device device;
    const DeviceType* type = nullptr;
    Value command;          ///< the caller sends it when `tick` returns true
    Value received;         ///< command of the controller, not checked yet
    bool is_heard = false;  ///< whether a receiver of its commands is connected
  };

  /// Makes the controller. @param label of the controller, for the record
  /// @throws std::runtime_error for a device whose fields are not registered; the exception of the controller's init
  RobotLoop(const std::string& robot, const std::string& label, RobotConfiguration configuration,
            ControllerHost::Factory make, const Robot::LogSink& log, Duration now);
  RobotLoop(const RobotLoop&) = delete;
  RobotLoop& operator=(const RobotLoop&) = delete;

  std::deque<Sensor>& sensors() { return sensors_; }
  std::deque<Actuator>& actuators() { return actuators_; }

  /// Carries out one period. @param passed time since the last call, in periods
  /// @return whether the commands of all actuators are to be sent
  bool tick(Duration now, std::uint64_t passed = 1);

  /// Begins the safe stop of the robot, after which the loop is over.
  void end(Duration now);

  State state() const { return state_; }
  End whyItEnds() const { return end_; }
  /// Returns the state for people: "waiting for ...", "running", ...
  const std::string& text() const { return text_; }

  /// Returns whether the last tick stepped the controller, even if it failed: then these are its frames.
  bool hasStepped() const { return has_stepped_; }
  const SensorFrame& sensorFrame() const { return frame_; }
  const CommandFrame& commandFrame() const { return *answer_; }
  const Registration& registration() const { return registration_; }
  const std::vector<Robot::DebugValue>& debugValues() const { return debug_values_; }
  std::uint64_t steps() const { return steps_; }
  /// Returns the number of times that sensors were lost.
  std::uint64_t stops() const { return stops_; }

 private:
  std::string missing(Duration now) const;
  std::string lost(Duration now) const;
  bool isLost(const Sensor& sensor, Duration now) const;
  void wait(Duration now);
  void run(Duration now, std::uint64_t passed);
  void carryOnStopping(Duration now);
  void step(Duration now);
  void makeFrame();
  /// @throws ByteError @return "", or the reason why the controller failed
  std::string readAnswer();
  void beginStop(Duration now, State state);
  /// @return whether the commands no longer change
  bool stop(Duration now);

  RobotConfiguration configuration_;
  std::deque<Sensor> sensors_;
  std::deque<Actuator> actuators_;
  Registration registration_;
  Robot robot_;  ///< robot for the safe stop, with the sensors of this loop
  std::unique_ptr<ControllerHost> host_;
  SensorFrame frame_;
  const CommandFrame* answer_ = nullptr;
  std::vector<Robot::DebugValue> debug_values_;
  State state_ = State::kWaiting;
  End end_ = End::kNone;
  std::string text_;
  Duration began_;
  Duration stop_began_{};
  std::uint64_t stop_periods_ = 0;
  std::uint64_t period_ = 0;  ///< period of the controller's time
  std::uint64_t steps_ = 0;
  std::uint64_t stops_ = 0;
  bool has_stepped_ = false;
};

}  // namespace swarmanoid
