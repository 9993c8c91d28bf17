/// XML schemas (XSD) of experiment files, made from the descriptions that the parser goes by.
#pragma once

#include <map>
#include <string>

#include "swarmanoid_interface/registry.hpp"

namespace swarmanoid {

/// What experiment files name in the attribute `library` of a plugin; "" or nothing where they need not.
using PluginLibraries = std::map<const Registry::Entry*, std::string>;

/// A schema of all that the parser accepts with the plugins that are loaded and the robots that are installed. Where a
/// library must be named, the schema asks for it in each place; the parser does so only in the first.
std::string experimentSchema(const PluginLibraries& libraries = {});

/// The same without robots of other packages: after loadBuiltInPlugins, with nothing else loaded, it does not depend on
/// what else is installed. What the suite loads only where a file names it is loaded for it.
/// @throws ConfigError if that cannot be loaded
std::string suiteSchema();

}  // namespace swarmanoid
