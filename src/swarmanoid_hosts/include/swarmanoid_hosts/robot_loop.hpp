/// One robot and its controller, period after period, without ROS: whoever has the robot's devices says what was heard
/// of them and what time it is, and sends their commands when the caller asks for it.
///
///     waiting ----> running <----> stopped      all devices are there; sensors are lost; all are back
///        |             |              |
///        |             +--> ending <--+         the controller failed, or the end was asked for
///        |                     |
///        +------> over <-------+                devices are missing at the start; the safe stop is done
///
/// While stopped and while ending, commands are the safe stop's (safe_stop.hpp). While stopped the controller is not
/// stepped and its time stands still; it goes on where it was, without a reset. After a failure it never goes on.
///
/// Time     the controller's is kEpoch at its first step and goes on by whole periods, missed ones included; dt is what
///          went by since its last step. `now` is any steady clock's.
/// Threads  all functions from one thread.
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
  /// Why it ends.
  enum class End { kNone, kAsked, kFailed, kMissing };

  /// A device's struct, and where its variable parts are kept.
  struct Value {
    std::shared_ptr<void> data;
    VariableParts parts;
  };
  struct Sensor {
    RobotConfiguration::Device device;
    const DeviceType* type = nullptr;
    Value reading;                  ///< to be written to
    std::optional<Duration> heard;  ///< when last
  };
  struct Actuator {
    RobotConfiguration::Device device;
    const DeviceType* type = nullptr;
    Value command;          ///< to be sent when `tick` says so
    Value received;         ///< of the controller, not looked at yet
    bool is_heard = false;  ///< somebody receives its commands
  };

  /// Makes the controller. @param label of it, for the record
  /// @throws std::runtime_error for a device whose fields are not registered; what the controller's init throws
  RobotLoop(const std::string& robot, const std::string& label, RobotConfiguration configuration,
            ControllerHost::Factory make, const Robot::LogSink& log, Duration now);
  RobotLoop(const RobotLoop&) = delete;
  RobotLoop& operator=(const RobotLoop&) = delete;

  std::deque<Sensor>& sensors() { return sensors_; }
  std::deque<Actuator>& actuators() { return actuators_; }

  /// One period. @param passed since the last one, in periods
  /// @return whether the commands of all actuators are to be sent
  bool tick(Duration now, std::uint64_t passed = 1);

  /// The robot is to stop safely, and then it is over.
  void end(Duration now);

  State state() const { return state_; }
  End whyItEnds() const { return end_; }
  /// Of the state, for people: "waiting for ...", "running", ...
  const std::string& text() const { return text_; }

  /// Whether the last tick stepped the controller, be it that it failed: then these are its frames.
  bool hasStepped() const { return has_stepped_; }
  const SensorFrame& sensorFrame() const { return frame_; }
  const CommandFrame& commandFrame() const { return *answer_; }
  const Registration& registration() const { return registration_; }
  const std::vector<Robot::DebugValue>& debugValues() const { return debug_values_; }
  std::uint64_t steps() const { return steps_; }
  /// How often sensors were lost.
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
  /// @throws ByteError @return "", or why the controller failed
  std::string readAnswer();
  void beginStop(Duration now, State state);
  /// @return whether the commands stay now
  bool stop(Duration now);

  RobotConfiguration configuration_;
  std::deque<Sensor> sensors_;
  std::deque<Actuator> actuators_;
  Registration registration_;
  Robot robot_;  ///< of the safe stop: sensors as they are here
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
  std::uint64_t period_ = 0;  ///< of the controller's time
  std::uint64_t steps_ = 0;
  std::uint64_t stops_ = 0;
  bool has_stepped_ = false;
};

}  // namespace swarmanoid
