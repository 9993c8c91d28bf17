#include "swarmanoid_recording/output/run_files.hpp"

#include "swarmanoid_interface/contains.hpp"
#include "swarmanoid_interface/plugin_library.hpp"

namespace swarmanoid {

void loadVisualisation(const std::string& label) {
  for (const DeclaredLibrary& declared : declaredLibraries()) {
    if (declared.isOfSuite() && contains(declared.visualisations, label)) {
      loadPluginLibrary(declared.library, {}, {});
      return;
    }
  }
  throw ConfigError({}, "found no visualisation '" + label + "', allowed: an installation whose packages declare it");
}

std::shared_ptr<OutFolder> openOutFolder(const RunFiles& files, const Experiment& experiment) {
  if (files.records_bag) {
    loadVisualisation("rosbag_recorder");
  }
  if (files.records_trajectories) {
    loadVisualisation("trajectory_recorder");
  }
  if (files.writes_frames) {
    loadVisualisation("opengl_render");
  }
  auto out = std::make_shared<OutFolder>(files.folder, files.prefix, files.rules);
  for (const std::string& file : experiment.files) {
    out->protect(file);
  }
  for (const std::string& file : files.reads) {
    if (!file.empty()) {
      out->protect(file);
    }
  }
  out->protectLoadedLibraries();
  return out;
}

void addObserver(Simulation& simulation, RunContext context, const std::string& asked_by, const std::string& id,
                 const Configuration& parameters) {
  const Registry::Entry& entry = Registry::instance().require(PluginKind::kObserver, parameters.name());
  auto observer = makePlugin<Observer>(entry);
  context.experiment = &simulation.experiment();
  context.asked_by = asked_by;
  context.outcome = [&simulation] { return simulation.outcome(); };  // the simulation owns the observer
  observer->configure(id, parameters, context);
  simulation.addObserver(observer);
}

}  // namespace swarmanoid
