#include "space_diagnostics.hpp"

namespace swarmanoid {
SpaceDiagnostics::SpaceDiagnostics(const ros::NodeHandle& own, const std::string& experiment,
                                   const SpaceDisplay& display, SimulationThread& thread)
    : display_(display), thread_(thread), updater_(ros::NodeHandle(), own, own.getNamespace()) {
  updater_.setHardwareID(experiment);
  updater_.add("simulation", this, &SpaceDiagnostics::report);
  constexpr double kInterval = 1.0;  // [s]
  timer_ = own.createWallTimer(ros::WallDuration(kInterval),
                               [this](const ros::WallTimerEvent&) { updater_.force_update(); });
}

void SpaceDiagnostics::report(diagnostic_updater::DiagnosticStatusWrapper& status) {
  using diagnostic_msgs::DiagnosticStatus;
  const SimulationThread::State state = thread_.state();
  status.summary(DiagnosticStatus::OK, toString(state));
  if (state == SimulationThread::State::kStopped) {
    status.mergeSummary(DiagnosticStatus::ERROR, thread_.stopReason());
    return;
  }
  std::size_t failed = 0;
  try {
    thread_.look([&](const Simulation& simulation) { failed = simulation.failures().size(); });
  } catch (const std::exception&) {
    return;  // the run was stopped meanwhile
  }
  if (failed > 0) {
    status.mergeSummary(DiagnosticStatus::ERROR, "controllers failed: " + std::to_string(failed));
  }
  const swarmanoid_msgs::Performance performance = display_.performance();
  status.add("tick", performance.tick);
  status.add("real-time factor", performance.real_time_factor);
  status.add("robots x ticks per second", performance.robot_ticks_per_s);
}

}  // namespace swarmanoid
