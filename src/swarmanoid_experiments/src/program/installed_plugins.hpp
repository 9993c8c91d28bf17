/// The plugins that can be named in an experiment file: those of the suite, and those of other packages that are
/// installed.
#pragma once

#include <map>
#include <vector>

#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_interface/registry.hpp"

namespace swarmanoid::program {

/// Maps plugins to their libraries, if the suite does not load these by itself.
using Origins = std::map<const Registry::Entry*, DeclaredLibrary>;

/// Returns what is registered, kind by kind.
std::vector<const Registry::Entry*> allEntries();

/// Loads all installed plugins. A library that cannot be loaded is a warning: the others are there all the same.
Origins loadInstalledPlugins();

}  // namespace swarmanoid::program
