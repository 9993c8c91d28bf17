#include "engine_diagnostics.hpp"

namespace swarmanoid {

EngineDiagnostics::EngineDiagnostics(const ros::NodeHandle& space, const Experiment& experiment,
                                     const SpaceDisplay& display, SimulationThread& thread)
    : display_(display), thread_(thread) {
  for (std::size_t i = 0; i < experiment.engines.size(); ++i) {
    const ros::NodeHandle own(space, "engines/" + experiment.engines[i].id);
    updaters_.push_back(std::make_unique<diagnostic_updater::Updater>(ros::NodeHandle(), own, own.getNamespace()));
    updaters_.back()->setHardwareID(experiment.name);
    updaters_.back()->add("engine",
                          [this, i](diagnostic_updater::DiagnosticStatusWrapper& status) { report(i, status); });
  }
  constexpr double kInterval = 1.0;  // [s]
  timer_ = space.createWallTimer(ros::WallDuration(kInterval), [this](const ros::WallTimerEvent&) {
    for (const auto& updater : updaters_) {
      updater->force_update();
    }
  });
}

void EngineDiagnostics::report(std::size_t engine, diagnostic_updater::DiagnosticStatusWrapper& status) {
  using diagnostic_msgs::DiagnosticStatus;
  EngineReport report;
  try {
    thread_.look([&](const Simulation& simulation) { report = simulation.engineReports()[engine]; });
  } catch (const std::exception&) {
    status.summary(DiagnosticStatus::WARN, "stopped");
    return;
  }
  const EngineHealth& health = report.health;
  if (health.warning.empty()) {
    status.summary(DiagnosticStatus::OK, "works");
  } else {
    status.summary(DiagnosticStatus::WARN, health.warning);
  }
  status.add("kind", report.label);
  status.add("moves", report.moved);
  status.add("mirrors", report.mirrored);
  status.add("steps a tick", health.steps_per_tick);
  const swarmanoid_msgs::Performance performance = display_.performance();
  if (engine < performance.engines.size()) {
    constexpr double kMicro = 1e6;
    status.add("time of a step [us]", kMicro * performance.engines[engine].move / health.steps_per_tick);
  }
  for (const auto& [name, count] : health.counters) {
    status.add(name, count);
  }
}

}  // namespace swarmanoid
