#include "swarmanoid_interface/plugin_library.hpp"

#include <dlfcn.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>

#include "swarmanoid_interface/plain_text.hpp"
#include "swarmanoid_interface/process/user_code.hpp"

namespace swarmanoid {
namespace {

namespace fs = std::filesystem;

std::atomic<bool> are_paths_allowed{true};

std::vector<std::string> prefixes() {
  std::vector<std::string> result;
  Dl_info info;
  if (dladdr(reinterpret_cast<void*>(&loadPluginLibrary), &info) != 0 && info.dli_fname != nullptr) {
    // this library is <prefix>/lib/libswarmanoid_interface.so
    std::error_code ignored;
    result.push_back(fs::absolute(info.dli_fname, ignored).parent_path().parent_path().string());
  }
  if (const char* path = std::getenv("CMAKE_PREFIX_PATH")) {
    std::string rest = path;
    while (!rest.empty()) {
      const auto colon = rest.find(':');
      if (colon != 0) {
        result.push_back(rest.substr(0, colon));
      }
      rest = colon == std::string::npos ? "" : rest.substr(colon + 1);
    }
  }
  return result;
}

/// Loads the library, which runs its static constructors. Their exceptions cannot be caught: one ends the process, as a
/// crash does.
/// @return "", or the reason why the system's loader refuses it
std::string load(const std::string& file, const std::string& library) {
  const std::string part = "library '" + library + "'";
  const UserCode code{"loading", part, ""};
  const UserCall call(code);
  // RTLD_GLOBAL is not needed: plugins refer to each other by name in the registry
  std::string problem = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL) == nullptr ? dlerror() : "";
  restoreLocale();
  return problem;
}

void open(const std::string& file, const std::string& library, const SourceLocation& location) {
  std::error_code ignored;
  if (fs::is_other(fs::status(file, ignored))) {  // the loader would wait forever for the end of a pipe
    throw ConfigError(location, "library '" + library + "': found '" + file +
                                    "', which is a pipe or a device; allowed: a regular file");
  }
  if (const std::string problem = load(file, library); !problem.empty()) {
    throw ConfigError(location, "library '" + library + "' cannot be loaded: " + problem);
  }
}

/// @see cmake/swarmanoid_declare_plugins.cmake
DeclaredLibrary readDeclaration(const fs::path& file) {
  DeclaredLibrary declared;
  declared.library = file.filename().string();
  std::ifstream text(file);
  text >> declared.package;
  for (std::string kind, value; text >> kind >> value;) {
    if (kind == "visualisation") {
      declared.visualisations.push_back(value);
    } else if (kind == "scripts") {
      declared.scripts = value;
    } else if (kind == "loaded") {
      declared.is_built_in = value == "always" && declared.isOfSuite();
    }
  }
  return declared;
}

}  // namespace

void loadPluginLibrary(const std::string& library, const std::vector<std::string>& folders,
                       const SourceLocation& location) {
  const bool is_file = library.find('/') != std::string::npos || fs::path(library).extension() == ".so";
  if (is_file && !are_paths_allowed) {
    throw ConfigError(location, "library '" + library +
                                    "': found a file, allowed, as other computers reach the master: the name of an "
                                    "installed library; or allow_remote_libraries:=true at start");
  }
  std::error_code ignored;
  if (is_file && fs::exists(library, ignored)) {
    open(fs::absolute(library, ignored).string(), library, location);
    return;
  }
  const std::string name = is_file ? fs::path(library).filename().string() : "lib" + library + ".so";
  std::vector<std::string> places = are_paths_allowed ? folders : std::vector<std::string>();
  for (const std::string& prefix : prefixes()) {
    places.push_back(prefix + "/lib");
  }
  std::string searched;
  for (const std::string& place : places) {
    const fs::path file = fs::path(place) / name;
    if (fs::exists(file, ignored)) {
      open(file.string(), library, location);
      return;
    }
    searched += (searched.empty() ? "" : ", ") + place;
  }
  const std::string reason = load(name, library);
  if (reason.empty()) {
    return;
  }
  throw ConfigError(location, "library '" + library + "': found no " + name + " in " + searched +
                                  ", nor where the system's loader looks (" + reason + ")");
}

void allowLibrariesByPath(bool is_allowed) { are_paths_allowed = is_allowed; }

bool areLibrariesByPathAllowed() { return are_paths_allowed; }

std::vector<std::string> shareFolders() {
  std::vector<std::string> result;
  for (const std::string& prefix : prefixes()) {
    result.push_back(prefix + "/share");
  }
  return result;
}

std::vector<DeclaredLibrary> declaredLibraries() {
  std::map<std::string, DeclaredLibrary> libraries;  // by name
  std::error_code ignored;
  for (const std::string& folder : shareFolders()) {
    for (const auto& entry : fs::directory_iterator(fs::path(folder) / "swarmanoid/plugins", ignored)) {
      DeclaredLibrary declared = readDeclaration(entry.path());
      libraries.emplace(declared.library, std::move(declared));
    }
  }
  std::vector<DeclaredLibrary> result;
  for (auto& [name, declared] : libraries) {
    result.push_back(std::move(declared));
  }
  return result;
}

std::string findShared(const std::string& package, const std::string& path) {
  std::error_code ignored;
  for (const std::string& folder : shareFolders()) {
    const fs::path file = fs::path(folder) / package / path;
    if (fs::exists(file, ignored)) {
      return file.string();
    }
  }
  return "";
}

}  // namespace swarmanoid
