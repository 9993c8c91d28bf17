/// Named values from an experiment file (or any other source), each with its source location.
///
/// A Configuration is one element: its text, and its named children; an XML attribute and a child element of the same
/// name are equivalent. Readers get values by name and type. Unread values can be refused, so that a misspelt name is
/// an error and never a silent default.
///
/// Angles are degrees in files and radians everywhere else: `angle` converts.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_interface/range.hpp"
#include "swarmanoid_interface/state_archive.hpp"

namespace swarmanoid {

/// The location of a value. Line 0 means the whole file; an empty file name means no file (built in code).
struct SourceLocation {
  std::string file;
  int line = 0;

  /// "file:line", "file", or "".
  std::string toString() const;

  void archive(StateArchive& state) { state(file, line); }
};

/// A mistake of the user: "file:line: found ..., allowed: ..."; the location is omitted if the value is in no file.
class ConfigError : public std::runtime_error {
 public:
  ConfigError(const SourceLocation& location, const std::string& message);
  const SourceLocation& location() const { return location_; }

 private:
  SourceLocation location_;
};

class Configuration {
 public:
  Configuration() = default;
  Configuration(std::string name, std::string text, SourceLocation location)
      : name_(std::move(name)), text_(std::move(text)), location_(std::move(location)) {}

  const std::string& name() const { return name_; }
  /// Returns the element's own text, without surrounding white space.
  const std::string& text() const { return text_; }
  const SourceLocation& location() const { return location_; }
  const std::vector<Configuration>& children() const { return children_; }
  Configuration& add(Configuration child);
  Configuration& set(const std::string& name, const std::string& text);

  bool has(std::string_view key) const { return find(key) != nullptr; }
  /// Returns the first child of that name and marks it as read; null if there is none.
  const Configuration* find(std::string_view key) const;

  /// These functions return values by name. Without a fallback a missing key is an error.
  /// @throws ConfigError naming the key, the value found and the allowed values
  double number(std::string_view key, Range range = {}) const;
  double number(std::string_view key, double fallback, Range range = {}) const;
  std::int64_t integer(std::string_view key, Range range = {}) const;
  std::int64_t integer(std::string_view key, std::int64_t fallback, Range range = {}) const;
  bool boolean(std::string_view key) const;
  bool boolean(std::string_view key, bool fallback) const;
  std::string text(std::string_view key) const;
  std::string text(std::string_view key, const std::string& fallback) const;
  Color color(std::string_view key) const;
  Color color(std::string_view key, Color fallback) const;
  /// "x, y"
  Eigen::Vector2d vector2(std::string_view key) const;
  /// "x, y, z"
  Eigen::Vector3d vector3(std::string_view key) const;
  Eigen::Vector3d vector3(std::string_view key, const Eigen::Vector3d& fallback) const;
  /// Converts an angle, which is in degrees in the file. @return radians
  double angle(std::string_view key, double fallback_rad, Range range_deg = {}) const;

  /// @throws ConfigError for the first child that no reader has read, with the nearest name among `known`, or for one
  /// that occurs twice
  void refuseUnread(const std::vector<std::string>& known = {}) const;

  void archive(StateArchive& state) { state(name_, text_, location_, children_, read_); }

 private:
  const Configuration* firstOf(std::string_view key) const;
  const Configuration& require(std::string_view key) const;

  std::string name_;
  std::string text_;
  SourceLocation location_;
  std::vector<Configuration> children_;
  mutable bool read_ = false;
};

/// These functions read a whole text strictly: besides the value, only surrounding white space is allowed.
/// @throws ConfigError with the value found and the allowed values; `what` names the value in the message
double parseNumber(const std::string& text, const std::string& what, const SourceLocation& location, Range range = {});
std::int64_t parseInteger(const std::string& text, const std::string& what, const SourceLocation& location,
                          Range range = {});
bool parseBoolean(const std::string& text, const std::string& what, const SourceLocation& location);
Color parseColorOrThrow(const std::string& text, const std::string& what, const SourceLocation& location);
/// Returns the shortest text that is read as this number.
std::string numberText(double value);
/// Reads `count` numbers separated by commas, each in the range.
std::vector<double> parseNumbers(const std::string& text, std::size_t count, const std::string& what,
                                 const SourceLocation& location, Range range = {});

/// Returns the candidate with the smallest edit distance to `word`; nothing if none is near (distance above a third of
/// its length, at least 2).
std::optional<std::string> nearestName(std::string_view word, const std::vector<std::string>& candidates);

/// Returns "; did you mean 'x'?" or "".
std::string didYouMean(std::string_view word, const std::vector<std::string>& candidates);

/// "found the engine 'grund', allowed: ground, air; did you mean 'ground'?" @param what such as "the engine"
std::string unknownName(const std::string& what, const std::string& name, const std::vector<std::string>& allowed);

/// Returns "a, b, c" for messages that list the allowed names.
std::string joinNames(const std::vector<std::string>& names);

}  // namespace swarmanoid
