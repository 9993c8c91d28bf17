/// Finds and loads the shared libraries that plugins live in.
#pragma once

#include <string>
#include <vector>

#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid {

/// Loads `lib<name>.so` (or the file itself, if `library` has a slash or ends in .so), once; loading it again does
/// nothing. Looked for in `folders`, then in lib/ of every prefix of CMAKE_PREFIX_PATH, then beside this library, then
/// where the system's loader looks.
/// @throws ConfigError at `location`, with every place that was searched or the loader's own words
void loadPluginLibrary(const std::string& library, const std::vector<std::string>& folders,
                       const SourceLocation& location);

/// Whether libraries may be named by their files, and be looked for in folders that an experiment file names; so it is
/// at first. Else only what is installed is loaded. For the whole process, from now on.
void allowLibrariesByPath(bool is_allowed);

/// Folders that hold `share/` data of this installation, most important first: of the prefix that this library is in,
/// then of every prefix of CMAKE_PREFIX_PATH. A devel space and an install space have the same layout.
std::vector<std::string> shareFolders();

/// A library with plugins, as the package that builds it declares it (cmake/swarmanoid_declare_plugins.cmake).
struct DeclaredLibrary {
  std::string library;  ///< as loadPluginLibrary takes it
  std::string package;
};

/// All that the packages of this installation, and of every prefix of CMAKE_PREFIX_PATH, declare: by name, each once.
std::vector<DeclaredLibrary> declaredLibraries();

/// The first existing `share/<package>/<path>`; "" if there is none.
std::string findShared(const std::string& package, const std::string& path);

}  // namespace swarmanoid
