/// The plugins of this installation: the suite's own, and those of the libraries that packages declare.
#pragma once

#include <map>
#include <vector>

#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_interface/registry.hpp"

namespace swarmanoid::program {

/// Maps plugins to the libraries that experiment files must name for them; `library` is "" if the suite loads it by
/// itself.
using PluginOrigins = std::map<const Registry::Entry*, DeclaredLibrary>;

/// Returns all loaded plugins, by kind, label and implementation.
std::vector<const Registry::Entry*> allPlugins();

/// Loads all installed plugins, which runs code of their libraries. Libraries that cannot be loaded, invalid robots and
/// duplicate plugins cause warnings on the error stream; the rest is loaded nevertheless.
PluginOrigins loadInstalledPlugins();

}  // namespace swarmanoid::program
