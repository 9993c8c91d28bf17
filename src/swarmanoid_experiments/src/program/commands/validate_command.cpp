// `swarmanoid validate`.
#include <algorithm>
#include <filesystem>
#include <memory>

#include "../commands.hpp"
#include "../experiment_options.hpp"
#include "../output/standard_output.hpp"
#include "../processes/parent_process.hpp"
#include "swarmanoid_experiment_files/experiment_lookup.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/process/user_code_watch.hpp"
#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid::program {
namespace {

struct ValidateOptions : ExperimentOptions {
  bool path = false;
  bool no_libraries = false;
  bool end_with_parent = false;
};

/// Replaces a controller in Python, or one whose library is not loaded.
class IdleController final : public Controller {
 public:
  void init(Robot&, const Configuration&) override {}
  void step(Time, Duration) override {}
  void reset() override {}
};

bool isKnown(PluginKind kind, const std::string& label, const std::string& implementation = "") {
  return Registry::instance().find(kind, label, implementation) != nullptr;
}

/// Returns whether all parts of the experiment except the controllers are available.
bool canBeBuilt(const Experiment& experiment) {
  const auto areKnown = [](PluginKind kind, const std::vector<DeviceDescription>& devices) {
    return std::all_of(devices.begin(), devices.end(), [kind](const DeviceDescription& device) {
      return isKnown(kind, device.type, device.implementation);
    });
  };
  return std::all_of(experiment.engines.begin(), experiment.engines.end(),
                     [](const EngineDescription& engine) { return isKnown(PluginKind::kEngine, engine.label); }) &&
         std::all_of(experiment.rules.begin(), experiment.rules.end(),
                     [](const RuleDescription& rule) {
                       return rule.script.empty() && isKnown(PluginKind::kRule, rule.label);
                     }) &&
         std::all_of(experiment.arena.entities.begin(), experiment.arena.entities.end(),
                     [](const EntityDescription& entity) { return isKnown(PluginKind::kEntity, entity.type); }) &&
         std::all_of(experiment.controllers.begin(), experiment.controllers.end(),
                     [&](const ControllerDescription& controller) {
                       return areKnown(PluginKind::kSensor, controller.sensors) &&
                              areKnown(PluginKind::kActuator, controller.actuators);
                     });
}

/// @return a description of the experiment
std::string build(Experiment experiment, SuppliedParts supplied = {}) {
  // a check must not touch the outputs of visualisations
  experiment.visualisations.clear();
  const Simulation simulation(std::move(experiment), {}, std::move(supplied));
  return std::to_string(simulation.space().entities.size()) + " entities, " + std::to_string(simulation.robotCount()) +
         " robots";
}

std::string validateWithoutLibraries(const ValidateOptions& options) {
  auto [experiment, libraries] = readWithoutLibraries(options);
  SuppliedParts idle;
  for (const ControllerDescription& controller : experiment.controllers) {
    if (!controller.script.empty() || !isKnown(PluginKind::kController, controller.label)) {
      idle.controllers[controller.id] = [] { return std::make_shared<IdleController>(); };
    }
  }
  const std::string file = experiment.file;
  const std::string unloaded = libraries.empty() ? "" : " as far as can be told without " + joinNames(libraries);
  if (!canBeBuilt(experiment)) {
    return file + ": valid" + unloaded +
           "; not built, for these have an engine, a rule, a device or an arena object of it";
  }
  return file + ": valid" + unloaded + ", " + build(std::move(experiment), std::move(idle));
}

std::string validate(const ValidateOptions& options) {
  Experiment experiment = readExperiment(options);
  const std::string file = experiment.file;
  return file + ": valid, " + build(std::move(experiment));
}

}  // namespace

Command addValidateCommand(CLI::App& app) {
  auto options = std::make_shared<ValidateOptions>();
  CLI::App* command = app.add_subcommand("validate", "read and build an experiment, and say what is wrong");
  addExperimentOptions(*command, *options);
  command->add_flag("--path", options->path, "only say the file's full name");
  command->add_flag(
      "--no-libraries", options->no_libraries,
      "load no library that the file names, and so run no code of others; what they bring is not checked");
  command->add_flag("--end-with-parent", options->end_with_parent,
                    "end when the process does that has started it, as the launch file asks for");
  command->add_option("--set-all", options->all_settings,
                      "several path=value in one text, as the launch argument set:= has them");
  return [options] {
    if (options->end_with_parent) {
      endWithParent();
    }
    // computed before users' code runs, which may change the working directory
    const std::string full_name = std::filesystem::absolute(findExperiment(options->file)).string();
    const UserCodeWatch watch({nullptr, options->watchdog});
    const std::string found = options->no_libraries ? validateWithoutLibraries(*options) : validate(*options);
    print(options->path ? full_name : found + "\n");
    return ExitCode::kFinished;
  };
}

}  // namespace swarmanoid::program
