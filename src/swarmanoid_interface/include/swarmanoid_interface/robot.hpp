/// The interface of a robot for its controller: the devices that its configuration lists, a log, a random stream
/// (thesis 3.3, "Robot Common Interface").
///
/// The class is the same in the simulator and on a robot. The provider of the devices (the simulator's banks, or a
/// binding to topics) fills in the references; they stay valid as long as the robot object.
#pragma once

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "swarmanoid_interface/random.hpp"
#include "swarmanoid_interface/state_archive.hpp"
#include "swarmanoid_interface/time.hpp"

namespace swarmanoid {

/// A controller requested a device that its configuration does not list.
class DeviceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

enum class LogLevel { kInfo, kWarning, kError };

class alignas(64) Robot {
 public:
  using LogSink = std::function<void(LogLevel, const std::string& robot, const std::string& text)>;
  using DebugValue = std::pair<std::string, std::string>;
  static constexpr std::size_t kMostDebugKeys = 100;
  static constexpr std::size_t kLongestDebugText = 1000;  ///< [bytes]

  /// @param name unique, such as "fb_1"
  /// @param type the name of its description, as in the experiment file: "footbot", or one of the user's own
  Robot(std::string name, std::string type, std::uint64_t seed);
  Robot(const Robot&) = delete;
  Robot& operator=(const Robot&) = delete;

  const std::string& name() const { return name_; }
  const std::string& type() const { return type_; }

  /// Returns the readings of a sensor, refreshed before each step. Call it once, in init, and keep the reference.
  /// @throws DeviceError if the configuration does not list it
  template <class Device>
  const Device& sensor() const {
    return *static_cast<const Device*>(find(sensors_, Device::kType, "sensor"));
  }

  /// Returns the command of an actuator; a written value stays until it is changed. Call it once, in init.
  /// @throws DeviceError if the configuration does not list it
  template <class Device>
  Device& actuator() {
    return *static_cast<Device*>(find(actuators_, Device::kType, "actuator"));
  }

  /// The same by type name, for controllers that find fields by the device's descriptor (device_type.hpp).
  const void* sensor(const std::string& type) const { return find(sensors_, type.c_str(), "sensor"); }
  void* actuator(const std::string& type) { return find(actuators_, type.c_str(), "actuator"); }

  bool hasSensor(const std::string& type) const;
  bool hasActuator(const std::string& type) const;

  /// The controller's own random numbers: the same for one seed, robot and tick, independent of other robots and
  /// processes.
  RandomStream& random() { return random_; }

  /// Writes a text to the log, prefixed with the robot's name, as a line of its own: line breaks at its end are
  /// removed. At most 10 texts per second of robot time are written: the rest is dropped, and one text reports that. A
  /// text longer than 10,000 bytes is truncated, and marked as such.
  void log(LogLevel level, const std::string& text);
  void log(const std::string& text) { log(LogLevel::kInfo, text); }

  /// Sets a named value for people, shown in the text table's companion file, on a topic and as text in rviz. It does
  /// not affect the simulation, except that a handover rule in the experiment file can wait for it. After the first use
  /// of a key, a value of up to 64 letters allocates nothing. A robot has at most kMostDebugKeys keys, since each use
  /// of a key searches them, and keys and values at most kLongestDebugText bytes: the rest is left out, and one warning
  /// in the log reports the first case.
  void debug(std::string_view key, std::string_view value);
  const std::vector<DebugValue>& debugValues() const { return debug_values_; }

  // Functions for providers of devices only.
  void provideSensor(const std::string& type, const void* readings);
  void provideActuator(const std::string& type, void* command);
  void setLogSink(LogSink sink) { log_sink_ = std::move(sink); }
  /// Returns to the state after construction, with another seed; devices and the sink of the log stay.
  void restart(std::uint64_t seed);
  /// Sets another seed for the steps from now on.
  void reseed(std::uint64_t seed) { random_.reseed(seed); }
  /// Random numbers, debug values and the limit of the log, for snapshots.
  void archive(StateArchive& state) {
    state(random_, time_, debug_values_, has_warned_of_debug_, log_window_start_, logged_in_window_);
  }
  /// Is called before each step.
  void startTick(std::uint64_t tick, Time time) {
    time_ = time;
    random_.startTick(tick);
  }

 private:
  using Devices = std::vector<std::pair<std::string, void*>>;
  void* find(const Devices& devices, const char* type, const char* kind) const;
  void warnOfDebug(const std::string& problem);

  // The members that startTick writes are adjacent, which saves cache misses with many robots.
  RandomStream random_;
  Time time_ = kEpoch;
  std::string name_;
  std::string type_;
  Devices sensors_;
  Devices actuators_;
  LogSink log_sink_;
  std::vector<DebugValue> debug_values_;
  bool has_warned_of_debug_ = false;
  Time log_window_start_ = kEpoch;
  int logged_in_window_ = 0;
};

}  // namespace swarmanoid
