#include "recorder.hpp"

#include <filesystem>

#include "swarmanoid_interface/plugin_library.hpp"

namespace swarmanoid {
namespace {

/// @param parameters named like the visualisation's label
std::string attach(Simulation& simulation, const RunContext& context, const std::string& id,
                   const Configuration& parameters) {
  const auto* entry = Registry::instance().find(PluginKind::kVisualisation, parameters.name());
  auto visualisation = makePlugin<Visualisation>(*entry);
  RunContext own_context = context;
  own_context.experiment = &simulation.experiment();
  visualisation->configure(id, parameters, own_context);
  simulation.addVisualisation(visualisation);
  return std::filesystem::absolute(std::filesystem::path(context.out_folder) / parameters.text("file")).string();
}

}  // namespace

std::string record(Simulation& simulation, const RunContext& context, const SpaceOptions& options,
                   const std::string& space) {
  loadPluginLibrary("swarmanoid_recording", {}, {});
  Configuration parameters("rosbag_recorder", "", {});
  parameters.set("file", options.record);
  parameters.set("node", space.substr(space.find_first_not_of('/')));
  std::string controllers;
  for (const std::string& robot : options.record_controllers) {
    controllers += (controllers.empty() ? "" : " ") + robot;
  }
  parameters.set("controllers", controllers.empty() ? "none" : controllers);
  return attach(simulation, context, "record", parameters);
}

std::string writeHashes(Simulation& simulation, const RunContext& context, const std::string& file) {
  Configuration parameters("hash_recorder", "", {});
  parameters.set("file", file);
  return attach(simulation, context, "hashes", parameters);
}

}  // namespace swarmanoid
