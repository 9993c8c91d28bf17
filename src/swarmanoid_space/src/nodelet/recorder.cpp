#include "recorder.hpp"

#include <filesystem>

#include "swarmanoid_interface/plugin_library.hpp"

namespace swarmanoid {

std::string record(Simulation& simulation, const RunContext& context, const std::string& file,
                   const std::string& space) {
  loadPluginLibrary("swarmanoid_recording", {}, {});
  const auto* entry = Registry::instance().find(PluginKind::kVisualisation, "rosbag_recorder");
  auto recorder = makePlugin<Visualisation>(*entry);
  Configuration parameters("rosbag_recorder", "", {});
  parameters.set("file", file);
  parameters.set("node", space.substr(space.find_first_not_of('/')));
  RunContext own_context = context;
  own_context.experiment = &simulation.experiment();
  recorder->configure("record", parameters, own_context);
  simulation.addVisualisation(recorder);
  return std::filesystem::absolute(std::filesystem::path(context.out_folder) / file).string();
}

}  // namespace swarmanoid
