/// The diffusion experiment, which benchmarks of engines run in turn with the engine's library alone.
#pragma once

#include <cmath>
#include <ctime>
#include <memory>
#include <string>
#include <vector>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_experiment_files/testing/diffusion_experiment.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid::benchmarks {

constexpr double kAreaPerRobot = 1.6;  // m2

/// Processor time of this process, all threads [s].
inline double processorSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Starts an experiment up to the state before the first tick. @param engine its element in the experiment file, with
/// the id 'ground'
/// @param tick [s]
inline std::unique_ptr<Simulation> startDiffusion(int robots, const std::string& engine, double tick = 0.1) {
  const int tick_ms = static_cast<int>(std::lround(1e3 * tick));
  auto simulation = std::make_unique<Simulation>(
      parseExperiment(diffusionExperiment(robots, kAreaPerRobot, engine, tick_ms), "diffusion.xml"));
  simulation->start();
  return simulation;
}

inline std::vector<Row> robotsOf(const Space& space) {
  std::vector<Row> robots;
  for (const Row row : space.entities.order) {
    if (space.entities.model[row]->is_robot) {
      robots.push_back(row);
    }
  }
  return robots;
}

}  // namespace swarmanoid::benchmarks
