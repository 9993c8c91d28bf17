/// Collects commands for simulated robots that arrive from outside at any time, for example over topics: receivers put
/// them here, and the space takes them at the next tick. This file does not use ROS.
///
/// Threads  all functions may be called from any thread.
#pragma once

#include <map>
#include <mutex>
#include <set>
#include <string>
#include <utility>

#include "swarmanoid_interface/byte_stream.hpp"

namespace swarmanoid {

class CommandMailbox {
 public:
  /// Maps robot and device type to the command of the device, as bytes (device_type.hpp).
  using Commands = std::map<std::pair<std::string, std::string>, Bytes>;

  // Functions for receivers of commands.

  /// Registers a receiver of commands for this robot.
  void open(const std::string& robot);
  void close(const std::string& robot);
  /// Sets the command of the device for the next tick, and replaces an earlier one.
  /// @return "", or the reason why the command is refused: the robot has another command source
  std::string put(const std::string& robot, const std::string& device, Bytes command);

  // Functions for the space.

  bool isOpen(const std::string& robot) const;
  /// Accepts commands for these robots only from now on, and discards pending commands for other robots.
  void accept(std::set<std::string> robots);
  /// Returns true if no robot accepts commands.
  bool isIdle() const;
  /// Returns the commands since the last call, and removes them.
  Commands take();

 private:
  mutable std::mutex mutex_;
  std::set<std::string> open_;
  std::set<std::string> accepted_;
  Commands commands_;
};

}  // namespace swarmanoid
