#include "experiment_source.hpp"

#include <algorithm>
#include <vector>

#include "plugins/object_rules.hpp"
#include "python/values.hpp"
#include "swarmanoid_experiment_files/experiment_lookup.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_experiment_files/without_ros.hpp"
#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_space/models/limits.hpp"

namespace py = pybind11;

namespace swarmanoid::bindings {
namespace {

std::vector<Override> overridesOf(const ExperimentSource& source) {
  std::vector<Override> overrides;
  for (const auto& [path, value] : source.overrides) {
    overrides.push_back({path, fileText(value)});
  }
  return overrides;
}

/// Removes observers that would write files: without a folder a run writes nothing.
void leaveOutWriters(Experiment& experiment) {
  auto& observers = experiment.visualisations;
  const auto writes = [](const VisualisationDescription& observer) {
    const std::vector<Configuration>& values = observer.parameters.children();
    return std::any_of(values.begin(), values.end(), [&](const Configuration& value) {
      const bool is_switch = value.name().rfind("write_", 0) == 0;
      return is_switch ? observer.parameters.boolean(value.name()) : value.name() == "file";
    });
  };
  observers.erase(std::remove_if(observers.begin(), observers.end(), writes), observers.end());
}

/// @throws ConfigError if the value is out of range
std::int64_t argument(const char* name, std::int64_t value, Range range) {
  return parseInteger(std::to_string(value), name, {}, range);
}

}  // namespace

Experiment read(const ExperimentSource& source) {
  if (source.experiment.has_value() == source.text.has_value()) {
    throw py::type_error("allowed: either an experiment (a file or a name) or a text");
  }
  loadBuiltInPlugins();
  const std::vector<Override> overrides = overridesOf(source);
  Experiment experiment = source.text ? parseExperiment(*source.text, "<text>", overrides)
                                      : readExperiment(findExperiment(*source.experiment), overrides);
  for (const std::string& warning : takeExperimentWarnings()) {
    py::module_::import("warnings").attr("warn")(warning);
  }
  FrameworkDescription& framework = experiment.framework;
  framework.seed = source.seed.value_or(framework.seed);
  if (source.ticks) {
    framework.max_clock = static_cast<std::uint64_t>(argument("ticks", *source.ticks, limits::kTicks));
  }
  if (source.threads) {
    framework.threads = static_cast<int>(argument("threads", *source.threads, limits::kThreads));
  }
  refuseRobotsOfOthers(experiment);
  if (!source.may_write) {
    leaveOutWriters(experiment);
  }
  return experiment;
}

}  // namespace swarmanoid::bindings
