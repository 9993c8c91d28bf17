// The tick: its phases in order.
#include "swarmanoid_space/simulation/simulation.hpp"

#include <chrono>
#include <stdexcept>

#include "../assembly/stopwatch.hpp"
#include "../phases/phases.hpp"
#include "../world/world.hpp"
#include "swarmanoid_interface/plain_text.hpp"
#include "swarmanoid_interface/process/user_code.hpp"
#include "swarmanoid_interface/step_controller.hpp"

namespace swarmanoid {

bool Simulation::tick(const std::function<bool()>& is_disturbed) {
  World& world = *world_;
  if (isFinished()) {
    return true;
  }
  Stopwatch stopwatch(are_phases_timed_);
  beginTick();
  stopwatch.lap(phase_times_.rule);
  if (!has_sensed_) {
    phases::sense(world.space, world.assembly.groups, world.assembly.workers);
  }
  has_sensed_ = false;
  stopwatch.lap(phase_times_.sense);
  if (!world.lockstep.exchange(world.space, ControlAccess(world.space), world.assembly.robots, world.pending_events,
                               world.log_sink, is_disturbed)) {
    return false;
  }
  rules_have_begun_ = false;
  showPending();
  phases::report(world.space, ReportAccess(world.space), world.assembly.groups);
  if (world.supplied.commands != nullptr) {
    phases::applyTopics(world.space, world.space.commands, world.space.events, world.assembly.robots,
                        *world.supplied.commands, world.log_sink);
  }
  const phases::Found found = phases::control(world.space, ControlAccess(world.space), world.assembly.groups,
                                              world.assembly.robots, world.assembly.workers);
  restoreLocale();
  stopwatch.lap(phase_times_.control);
  phases::actuate(world.space, ActuateAccess(world.space), world.assembly.groups, faulty_, world.assembly.workers);
  stopFailedRobots(found.is_failure || !faulty_.empty(), found.is_stop);
  phases::cutPower(world.space, ActuateAccess(world.space), world.assembly.robots);
  stopwatch.lap(phase_times_.actuate);
  phases::move(world.space, MoveAccess(world.space), world.space.index, world.assembly.engines, world.assembly.workers,
               are_phases_timed_, phase_times_.engines);
  stopwatch.lap(phase_times_.move);
  phases::connect(world.space, ConnectAccess(world.space), AfterMoveAccess(world.space), world.assembly.engines,
                  world.assembly.groups);
  phases::handOver(world.space, HandOverAccess(world.space), world.space.events, world.assembly.engines,
                   world.assembly.robots, world.assembly.triggers,
                   writable<WrittenIn::kConnect>(world.assembly.memberships));
  removeFallen();
  stopwatch.lap(phase_times_.connect);
  phases::index(world.space, IndexAccess(world.space), world.assembly.workers);
  stopwatch.lap(phase_times_.index);
  phases::power(world.space, PowerAccess(world.space));
  stopwatch.lap(phase_times_.power);
  logNewOverflows();

  ++world.space.tick;
  world.space.time += world.space.clocktick;
  if (world.space.tick >= world.experiment.framework.max_clock) {
    world.space.events.push_back({Event::Kind::kFinished, "", "", "maxclock is reached"});
  }
  double seconds = 0.0;
  finish_asked_ = runRules();
  stopwatch.lap(seconds);
  phase_times_.rule += seconds;
  finish_asked_ = phases::show(world.space, world.assembly.observers) || finish_asked_;
  stopwatch.lap(phase_times_.show);
  if (std::chrono::steady_clock::now() >= next_flush_) {
    flush();
    stopwatch.lap(seconds);
    phase_times_.show += seconds;
  }
  return true;
}

/// Makes the events and interventions since the last tick visible.
void Simulation::showPending() {
  World& world = *world_;
  world.space.events.assign(world.pending_events.begin(), world.pending_events.end());
  world.pending_events.clear();
  world.space.interventions.assign(world.pending_interventions.begin(), world.pending_interventions.end());
  world.pending_interventions.clear();
}

/// @return whether a rule requests the end. A rule that fails ends the run; its tick is complete nevertheless, and is
/// shown.
bool Simulation::runRules() {
  World& world = *world_;
  try {
    return phases::rule(world.space, world.space.events, world.assembly.rules, world.queue);
  } catch (...) {
    const std::string failure = describeException();
    try {
      phases::show(world.space, world.assembly.observers);
    } catch (...) {
      throw std::runtime_error(failure + "; " + describeException());
    }
    throw;
  }
}

void Simulation::sense() {
  if (!isFinished() && !has_sensed_) {
    beginTick();
    phases::sense(world_->space, world_->assembly.groups, world_->assembly.workers);
    has_sensed_ = true;
  }
}

void Simulation::stopFailedRobots(bool have_failed, bool are_stopping) {
  if (have_failed) {
    noteFailures();
  }
  if (have_failed || are_stopping) {
    phases::stopSafely(world_->space, ActuateAccess(world_->space), world_->assembly.robots);
  }
}

void Simulation::noteFailures() {
  World& world = *world_;
  for (const Row row : faulty_) {
    RobotInstance* instance = world.assembly.findRobot(world.space.entities, row);
    if (!instance->has_failed) {
      instance->has_failed = true;
      instance->failure = kNotFinite;
      world.space.controllers[row].status = StepStatus::kFailed;
    }
  }
  for (RobotInstance& instance : world.assembly.robots) {
    if (!instance.has_failed || instance.failure.empty()) {
      continue;
    }
    instance.stops_since = world.space.time;
    world.failures.push_back({instance.robot->name(), world.space.tick, instance.failure});
    world.space.events.push_back({Event::Kind::kControllerFailed, instance.robot->name(), "", instance.failure});
    if (world.log_sink) {
      world.log_sink(
          LogLevel::kError, instance.robot->name(),
          "controller failed in tick " + std::to_string(world.space.tick) + ", the robot stops: " + instance.failure);
    }
    instance.failure.clear();
  }
}

/// Logs each device once, because a crowded run would otherwise log little else.
void Simulation::logNewOverflows() {
  const World& world = *world_;
  for (; logged_overflows_ < world.space.overflows.size(); ++logged_overflows_) {
    const Overflow& overflow = world.space.overflows[logged_overflows_];
    if (world.log_sink) {
      world.log_sink(LogLevel::kWarning, overflow.robot,
                     overflow.text + " in sight in tick " + std::to_string(overflow.first_tick) +
                         ", the rest is left out; this is said once");
    }
  }
}

}  // namespace swarmanoid
