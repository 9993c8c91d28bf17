#include "experiment_options.hpp"

#include <charconv>
#include <iostream>

#include "swarmanoid_experiment_files/experiment_lookup.hpp"
#include "swarmanoid_experiment_files/override_text.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_space/models/limits.hpp"

namespace swarmanoid::program {
namespace {

/// Rejects "nan", which the option parser would accept.
std::string refuseBadWatchdog(const std::string& text) {
  try {
    parseNumber(text, "--watchdog", {}, {0.1, 1e9});
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

std::vector<Override> settingsOf(const ExperimentOptions& options) {
  std::vector<Override> settings;
  for (const std::string& setting : options.settings) {
    settings.push_back(parseOverride(setting, "--set"));
  }
  const std::vector<Override> together = parseOverrides(options.all_settings, "--set-all");
  settings.insert(settings.end(), together.begin(), together.end());
  return settings;
}

void change(Experiment& experiment, const ExperimentOptions& options) {
  for (const std::string& warning : takeExperimentWarnings()) {
    std::cerr << "swarmanoid: warning: " << warning << '\n';
  }
  experiment.framework.seed = options.seed.value_or(experiment.framework.seed);
  if (options.ticks) {
    experiment.framework.max_clock = *options.ticks;
    experiment.framework.location = {"--ticks", 0};
  }
  experiment.framework.threads = options.threads.value_or(experiment.framework.threads);
}

}  // namespace

std::string refuseWrappedNumber(const std::string& text) {
  std::uint64_t number = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_whole = error == std::errc() && stop == text.data() + text.size();
  return is_whole ? "" : "found '" + text + "', allowed: a whole number from 0 to 18446744073709551615";
}

void addExperimentOptions(CLI::App& command, ExperimentOptions& options) {
  command.add_option("file", options.file, "an experiment file, or the name of an installed experiment")->required();
  command.add_option("--set", options.settings, "path=value: replaces what the file says (can be given again)");
  command.add_option("--seed", options.seed, "random seed, instead of the file's")->check(refuseWrappedNumber);
  command.add_option("--ticks", options.ticks, "ticks at the most, instead of maxclock")
      ->check(CLI::Range(std::uint64_t{1}, static_cast<std::uint64_t>(limits::kTicks.maximum)));
  command
      .add_option("--watchdog", options.watchdog,
                  "end when one call of a controller or another plugin takes longer [s]")
      ->check(refuseBadWatchdog);
}

Experiment readExperiment(const ExperimentOptions& options) {
  loadBuiltInPlugins();
  Experiment experiment = swarmanoid::readExperiment(findExperiment(options.file), settingsOf(options));
  change(experiment, options);
  return experiment;
}

UncheckedExperiment readWithoutLibraries(const ExperimentOptions& options) {
  loadBuiltInPlugins();
  UncheckedExperiment unchecked = swarmanoid::readWithoutLibraries(findExperiment(options.file), settingsOf(options));
  change(unchecked.experiment, options);
  return unchecked;
}

}  // namespace swarmanoid::program
