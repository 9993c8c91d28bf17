/// Runs of installed experiments with changed values, for tests of their results.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "swarmanoid_experiment_files/override_text.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid::test {

/// Started, before its first tick. @param overrides PATH=VALUE, as for --set
inline std::unique_ptr<Simulation> installed(const std::string& name, std::uint64_t seed,
                                             const std::vector<std::string>& overrides = {}, int threads = 1) {
  loadBuiltInPlugins();
  std::vector<Override> parsed;
  for (const std::string& text : overrides) {
    parsed.push_back(parseOverride(text, "--set"));
  }
  Experiment experiment = readExperiment(findShared("swarmanoid_experiments", "experiments/" + name + ".xml"), parsed);
  experiment.framework.seed = seed;
  experiment.framework.threads = threads;
  auto simulation = std::make_unique<Simulation>(std::move(experiment));
  simulation->start();
  return simulation;
}

/// Runs to the end.
inline void finish(Simulation& simulation) {
  while (!simulation.isFinished()) {
    simulation.tick();
  }
}

inline double metricOf(const Simulation& simulation, const std::string& name) {
  return std::get<double>(simulation.metrics().at(name));
}

/// Kendall's tau of values against their order: 1 if they always rise, -1 if they always fall; equal values count as
/// neither.
inline double kendall(const std::vector<double>& values) {
  double sum = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (std::size_t j = i + 1; j < values.size(); ++j) {
      sum += values[j] > values[i] ? 1.0 : values[j] < values[i] ? -1.0 : 0.0;
    }
  }
  const auto count = static_cast<double>(values.size());
  return sum / (0.5 * count * (count - 1.0));
}

}  // namespace swarmanoid::test
