#include "recorder.hpp"

#include <filesystem>

#include "swarmanoid_interface/plugin_library.hpp"

namespace swarmanoid {
namespace {

/// @param parameters named like the visualisation's label
void attach(Simulation& simulation, RunContext context, const std::string& id, const Configuration& parameters) {
  const auto* entry = Registry::instance().find(PluginKind::kVisualisation, parameters.name());
  auto visualisation = makePlugin<Visualisation>(*entry);
  context.experiment = &simulation.experiment();
  context.asked_by = "~" + id;
  visualisation->configure(id, parameters, context);
  simulation.addVisualisation(visualisation);
}

Configuration bagParameters(const SpaceOptions& options, const std::string& space) {
  Configuration parameters("rosbag_recorder", "", {});
  parameters.set("file", options.record);
  parameters.set("node", space.substr(space.find_first_not_of('/')));
  std::string controllers;
  for (const std::string& robot : options.record_controllers) {
    controllers += (controllers.empty() ? "" : " ") + robot;
  }
  parameters.set("controllers", controllers.empty() ? "none" : controllers);
  return parameters;
}

}  // namespace

std::shared_ptr<OutFolder> openOutFolder(const SpaceOptions& options, const Experiment& experiment) {
  if (!options.record.empty()) {
    loadPluginLibrary("swarmanoid_recording", {}, {});
  }
  auto out = std::make_shared<OutFolder>(options.out, "~", OutFolder::Rules{options.write_anywhere, options.force});
  for (const std::string& file : experiment.files) {
    out->protect(file);
  }
  out->protectLoadedLibraries();
  return out;
}

std::vector<std::string> addRecorders(Simulation& simulation, const RunContext& context, const SpaceOptions& options,
                                      const std::string& space) {
  const auto fullName = [&](const std::string& file) {
    return std::filesystem::absolute(std::filesystem::path(options.out) / file).string();
  };
  std::vector<std::string> said;
  if (!options.record.empty()) {
    attach(simulation, context, "record", bagParameters(options, space));
    said.push_back("recording " + fullName(options.record));
  }
  if (!options.hashes.empty()) {
    Configuration parameters("hash_recorder", "", {});
    parameters.set("file", options.hashes);
    attach(simulation, context, "hashes", parameters);
    said.push_back("writing state hashes to " + fullName(options.hashes));
  }
  return said;
}

}  // namespace swarmanoid
