#include "recorder.hpp"

#include <filesystem>

#include "swarmanoid_recording/output/run_files.hpp"

namespace swarmanoid {
namespace {

Configuration bagParameters(const SpaceOptions& options, const std::string& space) {
  Configuration parameters("rosbag_recorder", "", {});
  parameters.set("file", options.record);
  parameters.set("node", space.substr(space.find_first_not_of('/')));
  std::string controllers;
  for (const std::string& robot : options.record_controllers) {
    controllers += (controllers.empty() ? "" : " ") + robot;
  }
  parameters.set("controllers", controllers.empty() ? "none" : controllers);
  parameters.set("state", options.record_state ? "true" : "false");
  return parameters;
}

}  // namespace

std::shared_ptr<OutFolder> openOutFolder(const SpaceOptions& options, const Experiment& experiment) {
  RunFiles files;
  files.prefix = "~";
  files.folder = options.out;
  files.rules = {options.write_anywhere, options.force};
  files.records_bag = !options.record.empty();
  files.reads = {options.interventions};
  return openOutFolder(files, experiment);
}

std::vector<std::string> addRecorders(Simulation& simulation, const RunContext& context, const SpaceOptions& options,
                                      const std::string& space) {
  const auto fullName = [&](const std::string& file) {
    return std::filesystem::absolute(std::filesystem::path(options.out) / file).string();
  };
  std::vector<std::string> said;
  if (!options.record.empty()) {
    addObserver(simulation, context, "~record", "record", bagParameters(options, space));
    said.push_back("recording " + fullName(options.record));
  }
  if (!options.hashes.empty()) {
    Configuration parameters("hash_recorder", "", {});
    parameters.set("file", options.hashes);
    addObserver(simulation, context, "~hashes", "hashes", parameters);
    said.push_back("writing state hashes to " + fullName(options.hashes));
  }
  if (!options.save_interventions.empty()) {
    Configuration parameters("intervention_recorder", "", {});
    parameters.set("file", options.save_interventions);
    addObserver(simulation, context, "~save_interventions", "save_interventions", parameters);
    said.push_back("writing interventions to " + fullName(options.save_interventions));
  }
  return said;
}

}  // namespace swarmanoid
