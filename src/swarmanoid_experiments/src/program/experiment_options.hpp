/// Options shared by all commands that read an experiment: the file, and values that replace those in it.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_experiment_files/unchecked_experiment.hpp"

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

/// A check for the option parser, which would convert -1 and numbers that are too large to the largest number.
/// @return reason why the text is not a count, or ""
std::string refuseWrappedNumber(const std::string& text);

void addExperimentOptions(CLI::App& command, ExperimentOptions& options);

/// Reads the experiment and applies the options. Warnings go to the error stream. @throws ConfigError
Experiment readExperiment(const ExperimentOptions& options);
/// The same as readExperiment, but loads no library that the file names. @throws ConfigError
UncheckedExperiment readWithoutLibraries(const ExperimentOptions& options);

}  // namespace swarmanoid::program
