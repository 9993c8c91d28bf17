// Read access to a running simulation, and changes other than interventions.
#include <algorithm>

#include "../world/engines.hpp"
#include "swarmanoid_interface/process/user_code.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {

PhaseTimes& PhaseTimes::operator+=(const PhaseTimes& other) {
  sense += other.sense;
  control += other.control;
  actuate += other.actuate;
  move += other.move;
  connect += other.connect;
  index += other.index;
  power += other.power;
  rule += other.rule;
  show += other.show;
  engines.resize(std::max(engines.size(), other.engines.size()), 0.0);
  for (std::size_t i = 0; i < other.engines.size(); ++i) {
    engines[i] += other.engines[i];
  }
  return *this;
}

const Experiment& Simulation::experiment() const { return world_->experiment; }

const Space& Simulation::space() const { return world_->space; }

const std::vector<ControllerFailure>& Simulation::failures() const { return world_->failures; }

const Configuration& Simulation::engineParameters(const std::string& engine) const {
  return parametersOf(*world_, engineIndex(*world_, engine));
}

std::vector<EngineReport> Simulation::engineReports() const { return reportEngines(*world_); }

void Simulation::drawDevices(DeviceDrawings& drawings) const {
  drawings.clear();
  const Space& space = world_->space;
  const auto draw = [&](const auto& devices) {
    for (const auto& device : devices) {
      callPlugin("draw", device.part, space.tick, [&] { device->draw(space, drawings.of(device->type())); });
    }
  };
  for (const auto& group : world_->assembly.groups) {
    draw(group->sensors);
    draw(group->actuators);
  }
}

Lockstep& Simulation::lockstep() { return world_->lockstep; }

void Simulation::interrupt() { world_->lockstep.cancel(); }

void Simulation::wake() { world_->lockstep.wake(); }

std::size_t Simulation::robotCount() const { return world_->assembly.robots.size(); }

std::optional<ControllerStatus> Simulation::controllerStatus(Row row) const {
  const RobotInstance* robot = world_->assembly.findRobot(world_->space.entities, row);
  return robot == nullptr ? std::nullopt : std::optional<ControllerStatus>({robot->source, robot->has_failed});
}

Metrics Simulation::metrics() const {
  Metrics metrics;
  for (const Metric* metric : world_->space.metrics) {
    metrics[metric->name] = metric->value;
  }
  for (const ObserverInstance& observer : world_->assembly.observers) {
    if (!observer.is_given_up) {
      observer->addMetrics(metrics);
    }
  }
  return metrics;
}

std::optional<bool> Simulation::success() const {
  std::optional<bool> result;
  const auto judge = [&result](const auto& judges) {
    for (const auto& each : judges) {
      if (const auto judged = each.is_given_up ? std::nullopt : each->success()) {
        result = result.value_or(true) && *judged;
      }
    }
  };
  judge(world_->assembly.rules);
  judge(world_->assembly.observers);
  return result;
}

void Simulation::addObserver(std::shared_ptr<Observer> observer) {
  const std::string part = "visualisation '" + observer->id() + "'";
  world_->assembly.observers.push_back({{std::move(observer), part}});
}

void Simulation::setLogSink(Robot::LogSink sink) {
  world_->log_sink = std::move(sink);
  for (RobotInstance& instance : world_->assembly.robots) {
    instance.robot->setLogSink(world_->log_sink);
  }
}

}  // namespace swarmanoid
