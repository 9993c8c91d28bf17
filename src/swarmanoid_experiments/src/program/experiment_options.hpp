/// What commands that read an experiment have in common: the file, and options that replace what it says.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "swarmanoid_space/experiment_file/unchecked_experiment.hpp"

namespace swarmanoid::program {

struct ExperimentOptions {
  std::string file;
  std::optional<std::uint64_t> seed;
  std::optional<std::uint64_t> ticks;
  std::optional<int> threads;
  std::vector<std::string> settings;
  std::string all_settings;
  double watchdog = 0.0;  ///< [s]; 0: none
};

void addExperimentOptions(CLI::App& command, ExperimentOptions& options);

/// The experiment with what the options change in it. Warnings go to the error stream. @throws ConfigError
Experiment readExperiment(const ExperimentOptions& options);
/// The same, but no library that the file names is loaded. @throws ConfigError
UncheckedExperiment readWithoutLibraries(const ExperimentOptions& options);

}  // namespace swarmanoid::program
