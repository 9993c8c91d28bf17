/// Reads the private parameters of a node or nodelet strictly: values of another type or out of bounds and unread names
/// are refused, whereas ros::NodeHandle::param would use its default.
///
/// Threads  one thread; calls wait for the master.
/// Errors   ConfigError with the namespace, the parameter, the value found and the allowed values
#pragma once

#include <ros/node_handle.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid {

/// Converts parameters of any scalar type to text first, so that launch files may pass "" for "not given". Some
/// functions accept "none" too, since roslaunch lists arguments whose default is empty as required.
class ParameterReader {
 public:
  explicit ParameterReader(const ros::NodeHandle& own) : own_(own) {}

  std::string text(const std::string& name, const std::string& fallback);
  /// Returns "" if it is not given or "none".
  std::string optional(const std::string& name);
  double number(const std::string& name, double fallback, Range range);
  /// Returns an integer; nothing if it is not given or "none".
  std::optional<std::uint64_t> count(const std::string& name, Range range);
  bool boolean(const std::string& name, bool fallback);
  /// @param allowed the first one is the default
  std::string choice(const std::string& name, const std::vector<std::string>& allowed);
  /// Returns the words that spaces separate.
  std::vector<std::string> words(const std::string& name);
  /// Returns the same, or an empty list if the only word is "none".
  std::vector<std::string> optionalWords(const std::string& name);

  /// Refuses parameters that have not been read; call it last. @param parts names that other readers read: "engines"
  /// includes ~engines/ground/id
  void refuseUnread(const std::vector<std::string>& parts) const;

  SourceLocation location() const { return {own_.getNamespace(), 0}; }

 private:
  const ros::NodeHandle own_;
  std::vector<std::string> known_;
};

}  // namespace swarmanoid
