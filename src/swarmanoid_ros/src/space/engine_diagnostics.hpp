/// Publishes the engines' part of /diagnostics, one status each: the entities that the engine moves, the duration of a
/// step, and the failures.
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>

#include <memory>
#include <string>
#include <vector>

#include "space_display.hpp"
#include "swarmanoid_space/simulation/simulation_thread.hpp"

namespace swarmanoid {

class EngineDiagnostics {
 public:
  /// @param space the space's own handle; the statuses have the names of the engines' nodelets
  EngineDiagnostics(const ros::NodeHandle& space, const Experiment& experiment, const SpaceDisplay& display,
                    SimulationThread& thread);

 private:
  void report(std::size_t engine, diagnostic_updater::DiagnosticStatusWrapper& status);

  const SpaceDisplay& display_;
  SimulationThread& thread_;
  std::vector<std::unique_ptr<diagnostic_updater::Updater>> updaters_;
  ros::WallTimer timer_;  // wall time: a paused space is diagnosed too
};

}  // namespace swarmanoid
