#include "installed_plugins.hpp"

#include <iostream>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/contains.hpp"
#include "swarmanoid_space/experiment/experiment.hpp"
#include "swarmanoid_space/models/entity_model.hpp"

namespace swarmanoid::program {

std::vector<const Registry::Entry*> allPlugins() {
  std::vector<const Registry::Entry*> entries;
  for (const PluginKind kind : kPluginKinds) {
    const auto more = Registry::instance().all(kind);
    entries.insert(entries.end(), more.begin(), more.end());
  }
  return entries;
}

PluginOrigins loadInstalledPlugins() {
  loadBuiltInPlugins();
  PluginOrigins origins;
  for (const Registry::Entry* entry : allPlugins()) {
    origins[entry] = {};
  }
  for (const DeclaredLibrary& declared : declaredLibraries()) {
    if (declared.is_built_in || !declared.scripts.empty()) {
      continue;  // loaded, or without plugins of its own
    }
    try {
      loadPluginLibrary(declared.library, {}, {"package " + declared.package, 0});
    } catch (const ConfigError& error) {
      std::cerr << "swarmanoid: warning: " << error.what() << '\n';
    }
    for (const Registry::Entry* entry : allPlugins()) {
      const bool is_found =
          entry->kind == PluginKind::kObserver && contains(declared.visualisations, entry->description.label);
      origins.emplace(entry, is_found ? DeclaredLibrary{} : declared);
    }
  }
  for (const std::string& problem : robotProblems()) {
    std::cerr << "swarmanoid: warning: " << problem << '\n';
  }
  for (const Registry::Conflict& conflict : Registry::instance().conflicts()) {
    std::cerr << "swarmanoid: warning: " << describe(conflict) << '\n';
  }
  return origins;
}

}  // namespace swarmanoid::program
