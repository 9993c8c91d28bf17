// `swarmanoid schema`: the XML schema of experiment files.
#include <memory>

#include "../commands.hpp"
#include "../installed_plugins.hpp"
#include "../output/standard_output.hpp"
#include "swarmanoid_experiment_files/experiment_schema.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_space/experiment/experiment.hpp"

namespace swarmanoid::program {

Command addSchemaCommand(CLI::App& app) {
  auto is_of_suite = std::make_shared<bool>(false);
  CLI::App* command = app.add_subcommand("schema", "print the XML schema (XSD) of experiment files");
  command->add_flag("--suite", *is_of_suite, "without what other packages bring");
  return [is_of_suite] {
    if (*is_of_suite) {
      loadBuiltInPlugins();
      print(suiteSchema());
      return ExitCode::kFinished;
    }
    PluginLibraries libraries;
    for (const auto& [plugin, origin] : loadInstalledPlugins()) {
      libraries[plugin] = origin.library;
    }
    print(experimentSchema(libraries));
    return ExitCode::kFinished;
  };
}

}  // namespace swarmanoid::program
