/// Commands for simulated robots that come from outside at any time, such as over topics: whoever receives them puts
/// them here, and the space takes them at the next tick. No ROS here.
///
/// Threads  all functions from any thread.
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
  /// Robot and device type: the command of the device, as bytes (device_type.hpp).
  using Commands = std::map<std::pair<std::string, std::string>, Bytes>;

  // For those who receive commands.

  /// Somebody listens to commands for this robot.
  void open(const std::string& robot);
  void close(const std::string& robot);
  /// Replaces what has come for the device since the last tick.
  /// @return "", or why it is refused: the robot is commanded by somebody else
  std::string put(const std::string& robot, const std::string& device, Bytes command);

  // For the space.

  bool isOpen(const std::string& robot) const;
  /// Only commands for these robots are taken from now on; what has come for others is forgotten.
  void accept(std::set<std::string> robots);
  /// Commands are taken for nobody.
  bool isIdle() const;
  /// What has come since the last call.
  Commands take();

 private:
  mutable std::mutex mutex_;
  std::set<std::string> open_;
  std::set<std::string> accepted_;
  Commands commands_;
};

}  // namespace swarmanoid
