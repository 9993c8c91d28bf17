#include "remote_rules.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "swarmanoid_experiment_files/experiment_lookup.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_recording/output/inside_folder.hpp"

namespace swarmanoid {
namespace {

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

bool isInstalled(const std::string& experiment) {
  const std::vector<std::string> folders = shareFolders();
  const std::string file = findExperiment(experiment);
  return std::any_of(folders.begin(), folders.end(), [&](const std::string& folder) { return isInside(file, folder); });
}

std::string filesIn(const RemoteRules& rules) { return rules.folder.empty() ? "" : "files in " + rules.folder; }

[[noreturn]] void refuse(const std::string& parameter, const std::string& found, const std::string& allowed) {
  throw ConfigError({}, "~" + parameter + ": found '" + found + "', allowed, as other computers reach the master: " +
                            (allowed.empty() ? "nothing" : allowed) + "; or allow_remote_files:=true at start");
}

/// @param folder in which a relative name begins; "": the process's working directory
void check(const std::string& parameter, const std::string& name, const std::string& folder, const RemoteRules& rules) {
  if (!name.empty() && (rules.folder.empty() || !isInside(std::filesystem::path(folder) / name, rules.folder))) {
    refuse(parameter, name, filesIn(rules));
  }
}

}  // namespace

RemoteRules remoteRules(bool is_reachable) {
  RemoteRules rules;
  rules.any_file = !is_reachable || environment("SWARMANOID_ALLOW_REMOTE_FILES") == "true";
  rules.any_library = !is_reachable || environment("SWARMANOID_ALLOW_REMOTE_LIBRARIES") == "true";
  rules.folder = environment("SWARMANOID_FOLDER");
  return rules;
}

void checkExitCodeFile(const std::string& file, const RemoteRules& rules) {
  if (!rules.any_file) {
    check("exit_code", file, "", rules);
  }
}

void checkFiles(const SpaceOptions& options, const RemoteRules& rules) {
  if (rules.any_file) {
    return;
  }
  if (!isInstalled(options.experiment) &&
      (rules.folder.empty() || !isInside(findExperiment(options.experiment), rules.folder))) {
    const std::string here = filesIn(rules);
    refuse("experiment", options.experiment, "installed experiments" + (here.empty() ? "" : ", " + here));
  }
  check("out", options.out.empty() ? "." : options.out, "", rules);
  check("record", options.record, options.out, rules);
  check("hashes", options.hashes, options.out, rules);
  check("save_interventions", options.save_interventions, options.out, rules);
  check("interventions", options.interventions, "", rules);
  if (options.write_anywhere) {
    refuse("write_anywhere", "true", "false");
  }
  if (options.force) {
    refuse("force", "true", "false");
  }
}

}  // namespace swarmanoid
