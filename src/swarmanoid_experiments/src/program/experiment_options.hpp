/// The options that all commands share which read an experiment: the file, and values that replace those in it.
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

/// For the option parser, which would read -1 and numbers above the largest one as the largest one.
/// @return why it is no count; "" if it is one
std::string refuseWrappedNumber(const std::string& text);

void addExperimentOptions(CLI::App& command, ExperimentOptions& options);

/// Reads the experiment with the changes of the options. Warnings go to the error stream. @throws ConfigError
Experiment readExperiment(const ExperimentOptions& options);
/// Does the same, but loads no library that the file names. @throws ConfigError
UncheckedExperiment readWithoutLibraries(const ExperimentOptions& options);

}  // namespace swarmanoid::program
