/// Presets: how sensors, actuators and entities differ from ideal ones, as data of the installed packages.
///
/// An experiment says `<realism>typical</realism>` in <framework>, in a controller or in a device, and each device that
/// has a preset of that name gets what the preset holds: an implementation, values, errors. What the file itself says
/// of a device goes first. What <framework> says holds for entities, too; of their presets, values of a battery
/// (battery_...) count for robots that have one. The name "ideal" is always there, and means no preset.
#pragma once

#include <string>
#include <vector>

#include "swarmanoid_interface/registry.hpp"

namespace swarmanoid {

/// What `ideal` is called, which is meant where nothing is said.
constexpr const char* kIdealRealism = "ideal";

struct RealismPreset {
  PluginKind kind = PluginKind::kSensor;  ///< of the device: a sensor, an actuator, or an entity
  std::string device;                     ///< its type
  std::string name;                       ///< of the preset
  std::string source;                     ///< where its numbers are from
  /// As an experiment file would say it in the device: one element a line, no line break at the end.
  std::string content;
  std::string file;
};

/// All presets that are installed, sorted by device, then by name. Thread-safe.
/// @throws ConfigError for the first mistake in a file of presets
std::vector<RealismPreset> realismPresets();

/// kIdealRealism, then the names of presets, sorted. Files with mistakes do not count. Thread-safe.
const std::vector<std::string>& realismNames();

}  // namespace swarmanoid
