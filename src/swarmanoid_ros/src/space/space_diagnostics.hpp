/// Publishes the space's part of /diagnostics: its state, its speed, robots whose controllers failed.
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>

#include <string>

#include "space_display.hpp"
#include "swarmanoid_space/simulation/simulation_thread.hpp"

namespace swarmanoid {

class SpaceDiagnostics {
 public:
  SpaceDiagnostics(const ros::NodeHandle& own, const std::string& experiment, const SpaceDisplay& display,
                   SimulationThread& thread);

 private:
  void report(diagnostic_updater::DiagnosticStatusWrapper& status);

  const SpaceDisplay& display_;
  SimulationThread& thread_;
  diagnostic_updater::Updater updater_;
  ros::WallTimer timer_;  // wall time: a paused space is diagnosed too
};

}  // namespace swarmanoid
