/// Reads the private parameters of a node or nodelet, strictly: a value of another type, one out of bounds and a name
/// that nobody reads are refused, where ros::NodeHandle::param would go on with what it takes for usual.
///
/// Threads  of one thread; it waits for the master.
/// Errors   ConfigError with the namespace, the parameter, what was found and what is allowed
#pragma once

#include <ros/node_handle.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid {

/// Converts parameters of any scalar type to text first, so that launch files may pass "" for "not given"; where the
/// function says so, "none" too, since roslaunch lists arguments whose default is empty as required.
class ParameterReader {
 public:
  explicit ParameterReader(const ros::NodeHandle& own) : own_(own) {}

  std::string text(const std::string& name, const std::string& fallback);
  /// "" if it is not given or "none".
  std::string optional(const std::string& name);
  double number(const std::string& name, double fallback, Range range);
  /// A whole number; nothing if it is not given or "none".
  std::optional<std::uint64_t> count(const std::string& name, Range range);
  bool boolean(const std::string& name, bool fallback);
  /// @param allowed the first one is meant if it is not given
  std::string choice(const std::string& name, const std::vector<std::string>& allowed);
  /// What spaces separate.
  std::vector<std::string> words(const std::string& name);
  /// The same, but none of them if the only word is "none".
  std::vector<std::string> optionalWords(const std::string& name);

  /// To be called when all has been read. @param parts that others read: "engines" stands for ~engines/ground/id, too
  void refuseUnread(const std::vector<std::string>& parts) const;

  SourceLocation location() const { return {own_.getNamespace(), 0}; }

 private:
  const ros::NodeHandle own_;
  std::vector<std::string> known_;
};

}  // namespace swarmanoid
