/// XML schemas (XSD) of experiment files, generated from the descriptions that the parser uses.
#pragma once

#include <map>
#include <string>

#include "swarmanoid_interface/registry.hpp"

namespace swarmanoid {

/// Value of the attribute `library` for each plugin; "" or no entry where none is needed.
using PluginLibraries = std::map<const Registry::Entry*, std::string>;

/// A schema of everything that the parser accepts with the loaded plugins and the installed robots. Where a library
/// must be named, the schema requires it at each place; the parser requires it only at the first.
std::string experimentSchema(const PluginLibraries& libraries = {});

/// The same without robots of other packages. After loadBuiltInPlugins, with nothing else loaded, it does not depend on
/// other installed packages. Loads plugins of the suite that are otherwise loaded only where a file names them.
/// @throws ConfigError if one of them cannot be loaded
std::string suiteSchema();

}  // namespace swarmanoid
