// The tick, on one screen, and the life of a run around it.
#include "swarmanoid_space/simulation/simulation.hpp"

#include <algorithm>
#include <chrono>
#include <exception>

#include "../assembly/assembly.hpp"
#include "../assembly/stopwatch.hpp"
#include "../phases/phases.hpp"
#include "swarmanoid_interface/plain_text.hpp"
#include "swarmanoid_interface/process/user_code.hpp"
#include "swarmanoid_interface/step_controller.hpp"
#include "swarmanoid_space/lockstep/lockstep.hpp"

namespace swarmanoid {

PhaseTimes& PhaseTimes::operator+=(const PhaseTimes& other) {
  sense += other.sense;
  control += other.control;
  actuate += other.actuate;
  move += other.move;
  connect += other.connect;
  index += other.index;
  show += other.show;
  engines.resize(std::max(engines.size(), other.engines.size()), 0.0);
  for (std::size_t i = 0; i < other.engines.size(); ++i) {
    engines[i] += other.engines[i];
  }
  return *this;
}

bool Simulation::tick(const std::function<bool()>& is_disturbed) {
  if (isFinished()) {
    return true;
  }
  Stopwatch stopwatch;
  phases::sense(space_, assembly_->groups, assembly_->workers);
  stopwatch.lap(phase_times_.sense);
  if (!lockstep_->exchange(space_, assembly_->robots, pending_events_, log_sink_, is_disturbed)) {
    return false;
  }
  space_.events.assign(pending_events_.begin(), pending_events_.end());
  pending_events_.clear();
  phases::report(space_, assembly_->groups);
  if (supplied_.commands != nullptr) {
    phases::applyTopics(space_, space_.commands, space_.events, assembly_->robots, *supplied_.commands, log_sink_);
  }
  phases::control(space_, space_.controllers, assembly_->robots, assembly_->workers);
  restoreLocale();
  stopwatch.lap(phase_times_.control);
  phases::actuate(space_, assembly_->groups, faulty_);
  noteFailures();
  phases::stopSafely(space_, assembly_->robots);
  stopwatch.lap(phase_times_.actuate);
  phases::move(space_, assembly_->engines, assembly_->workers, phase_times_.engines);
  stopwatch.lap(phase_times_.move);
  phases::connect(space_, assembly_->engines, assembly_->groups);
  phases::handOver(space_, assembly_->robots, assembly_->triggers, assembly_->memberships);
  stopwatch.lap(phase_times_.connect);
  phases::index(space_, space_.index, space_.outside, space_.events);
  stopwatch.lap(phase_times_.index);
  logNewOverflows();

  ++space_.tick;
  space_.time += space_.clocktick;
  if (space_.tick >= experiment_.framework.max_clock) {
    space_.events.push_back({Event::Kind::kFinished, "", "", "maxclock is reached"});
  }
  finish_asked_ = phases::show(space_, assembly_->observers);
  stopwatch.lap(phase_times_.show);
  if (stopwatch.last() >= next_flush_) {
    double seconds = 0.0;
    flush();
    stopwatch.lap(seconds);
    phase_times_.show += seconds;
  }
  return true;
}

void Simulation::noteFailures() {
  for (const Row row : faulty_) {
    RobotInstance* instance = assembly_->findRobot(space_.entities, row);
    if (!instance->has_failed) {
      instance->has_failed = true;
      instance->failure = kNotFinite;
      space_.controllers[row].status = StepStatus::kFailed;
    }
  }
  for (RobotInstance& instance : assembly_->robots) {
    if (!instance.has_failed || instance.failure.empty()) {
      continue;
    }
    instance.stops_since = space_.time;
    failures_.push_back({instance.robot->name(), space_.tick, instance.failure});
    space_.events.push_back({Event::Kind::kControllerFailed, instance.robot->name(), "", instance.failure});
    if (log_sink_) {
      log_sink_(LogLevel::kError, instance.robot->name(),
                "controller failed in tick " + std::to_string(space_.tick) + ", the robot stops: " + instance.failure);
    }
    instance.failure.clear();
  }
}

/// Once a device: a crowded run would say little else.
void Simulation::logNewOverflows() {
  for (; logged_overflows_ < space_.overflows.size(); ++logged_overflows_) {
    const Overflow& overflow = space_.overflows[logged_overflows_];
    if (log_sink_) {
      log_sink_(LogLevel::kWarning, overflow.robot,
                overflow.text + " in sight in tick " + std::to_string(overflow.first_tick) +
                    ", the rest is left out; this is said once");
    }
  }
}

void Simulation::start() {
  is_started_ = true;
  phases::index(space_, space_.index, space_.outside, space_.events);
  space_.events.insert(space_.events.end(), pending_events_.begin(), pending_events_.end());
  pending_events_.clear();
  finish_asked_ = phases::show(space_, assembly_->observers);
  flush();
}

bool Simulation::isFinished() const {
  return finish_asked_ || finished_ || space_.tick >= experiment_.framework.max_clock;
}

namespace {

/// One that cannot write its file must not keep the others from writing theirs.
template <class Action>
void callAll(std::vector<ObserverInstance>& observers, const char* phase, Action action) {
  std::exception_ptr first_problem;
  for (ObserverInstance& observer : observers) {
    try {
      callPlugin(phase, observer.part, UserCode::kNoTick, [&] { action(observer); });
    } catch (...) {
      first_problem = first_problem ? first_problem : std::current_exception();
    }
  }
  if (first_problem) {
    std::rethrow_exception(first_problem);
  }
}

}  // namespace

void Simulation::flush() {
  next_flush_ = std::chrono::steady_clock::now() + std::chrono::seconds(1);
  callAll(assembly_->observers, "flush", [](ObserverInstance& observer) { observer->flush(); });
}

void Simulation::finish() {
  finished_ = true;
  // a run that has not begun has nothing to complete, and may not touch the files of an older one
  if (!is_started_) {
    return;
  }
  callAll(assembly_->observers, "finish", [](ObserverInstance& observer) {
    if (!observer.is_finished && !observer.is_given_up) {
      observer.is_finished = true;  // before the call: if that does not return, the others are still to be called
      observer->finish();
    }
  });
}

void Simulation::giveUp(const std::string& part) {
  for (ObserverInstance& observer : assembly_->observers) {
    observer.is_given_up = observer.is_given_up || observer.part == part;
  }
}

std::size_t Simulation::robotCount() const { return assembly_->robots.size(); }

Metrics Simulation::metrics() const {
  Metrics metrics;
  for (const ObserverInstance& observer : assembly_->observers) {
    if (!observer.is_given_up) {
      observer->addMetrics(metrics);
    }
  }
  return metrics;
}

std::optional<bool> Simulation::success() const {
  std::optional<bool> result;
  for (const ObserverInstance& observer : assembly_->observers) {
    if (const auto judged = observer.is_given_up ? std::nullopt : observer->success()) {
      result = result.value_or(true) && *judged;
    }
  }
  return result;
}

void Simulation::addObserver(std::shared_ptr<Observer> observer) {
  const std::string part = "visualisation '" + observer->id() + "'";
  assembly_->observers.push_back({{std::move(observer), part}});
}

void Simulation::setLogSink(Robot::LogSink sink) {
  log_sink_ = std::move(sink);
  for (RobotInstance& instance : assembly_->robots) {
    instance.robot->setLogSink(log_sink_);
  }
}

}  // namespace swarmanoid
