/// Finds and loads the shared libraries of plugins.
#pragma once

#include <string>
#include <vector>

#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid {

/// Loads `lib<name>.so` (or the file itself, if `library` has a slash or ends in .so), once; loading it again does
/// nothing. The library is searched in `folders`, then in lib/ of every prefix of CMAKE_PREFIX_PATH, then beside this
/// library, then in the search path of the system's loader.
/// @throws ConfigError at `location`, with every place that was searched or the loader's message
void loadPluginLibrary(const std::string& library, const std::vector<std::string>& folders,
                       const SourceLocation& location);

/// Sets whether libraries may be named by their files, and be searched in folders that an experiment file names;
/// initially they may. Otherwise only installed libraries are loaded. The setting holds for the whole process, from now
/// on.
void allowLibrariesByPath(bool is_allowed);
bool areLibrariesByPathAllowed();

/// Returns the folders that hold `share/` data of this installation, most important first: of the prefix that this
/// library is in, then of every prefix of CMAKE_PREFIX_PATH. A devel space and an install space have the same layout.
std::vector<std::string> shareFolders();

/// A library with plugins, as the package that builds it declares it (cmake/swarmanoid_declare_plugins.cmake).
struct DeclaredLibrary {
  std::string library;  ///< in the form that loadPluginLibrary accepts
  std::string package;
  std::vector<std::string> visualisations;  ///< their labels, which experiment files may name without the library
  std::string scripts;                      ///< language of the controllers and rules that it runs; "": none
  bool is_built_in = false;                 ///< loaded for every experiment; only of the suite's packages

  /// Whether a package of the suite declares it; their names start with "swarmanoid_".
  bool isOfSuite() const { return package.rfind("swarmanoid_", 0) == 0; }
};

/// Returns all libraries that the packages of this installation, and of every prefix of CMAKE_PREFIX_PATH, declare,
/// sorted by name, each once.
std::vector<DeclaredLibrary> declaredLibraries();

/// Returns the first existing `share/<package>/<path>`; "" if there is none.
std::string findShared(const std::string& package, const std::string& path);

}  // namespace swarmanoid
