/// Presets: differences of sensors, actuators and entities from ideal ones, as data files of the installed packages.
///
/// An experiment may contain `<realism>typical</realism>` in <framework>, in a controller or in a device. Each device
/// with a preset of that name gets the contents of the preset: an implementation, values, errors. Settings of the file
/// itself take precedence. The preset of <framework> applies to entities, too; its battery values (battery_...) apply
/// only to robots with a battery. The name "ideal" always exists, and means no preset.
#pragma once

#include <string>
#include <vector>

#include "swarmanoid_interface/registry.hpp"

namespace swarmanoid {

/// The name of the default, no preset.
constexpr const char* kIdealRealism = "ideal";

struct RealismPreset {
  PluginKind kind = PluginKind::kSensor;  ///< of the device: a sensor, an actuator, or an entity
  std::string device;                     ///< its type
  std::string name;                       ///< of the preset
  std::string source;                     ///< where its numbers are from
  /// The contents, as in the device's element of an experiment file: one element a line, no line break at the end.
  std::string content;
  std::string file;
};

/// All presets that are installed, sorted by device, then by name. Thread-safe.
/// @throws ConfigError for the first mistake in a file of presets
std::vector<RealismPreset> realismPresets();

/// kIdealRealism, then the names of presets, sorted. Invalid files are skipped. Thread-safe.
const std::vector<std::string>& realismNames();

}  // namespace swarmanoid
