/// The plugins of this installation: the suite's own, and those of the libraries that packages declare.
#pragma once

#include <map>
#include <vector>

#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_interface/registry.hpp"

namespace swarmanoid::program {

/// Maps plugins to the libraries that experiment files name for them; `library` is "" where the suite loads it by
/// itself.
using PluginOrigins = std::map<const Registry::Entry*, DeclaredLibrary>;

/// Returns all plugins that are loaded, by kind, label and implementation.
std::vector<const Registry::Entry*> allPlugins();

/// Loads all installed plugins, which runs code of their libraries. What cannot be loaded, a robot that is wrong, and
/// a plugin that is there twice are warnings on the error stream: the others are loaded all the same.
PluginOrigins loadInstalledPlugins();

}  // namespace swarmanoid::program
