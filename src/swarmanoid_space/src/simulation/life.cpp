// The life cycle of a run: build, start, end, reset.
#include <algorithm>
#include <exception>
#include <stdexcept>
#include <utility>

#include "../assembly/stopwatch.hpp"
#include "../interventions/carry_out.hpp"
#include "../phases/phases.hpp"
#include "../snapshot/restart.hpp"
#include "../world/build.hpp"
#include "../world/engines.hpp"
#include "../world/entities.hpp"
#include "../world/scripts.hpp"
#include "swarmanoid_interface/expects.hpp"
#include "swarmanoid_interface/process/user_code.hpp"
#include "swarmanoid_space/intervention.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {

Simulation::Simulation(Experiment experiment, RunContext context, SuppliedParts supplied)
    : world_(std::make_unique<World>(std::move(experiment), std::move(context), std::move(supplied))) {
  buildEngines(*world_);
  build(*world_);
  buildRules(*world_);
  if (world_->context.keeps_start) {
    if (auto start = startOf(*world_)) {
      start_ = std::make_unique<Snapshot>(std::move(start));
    }
  }
  resetRules();
  world_->context.outcome = [this] { return outcome(); };
  buildObservers(*world_);
}

Simulation::~Simulation() {
  try {
    finish();
  } catch (...) {
    // a recorder that cannot complete its file must not end the program; callers of finish() get the error
  }
  try {
    unbuild(*world_);
  } catch (...) {
    // exceptions of plugins are harmless during destruction
  }
}

void Simulation::start() {
  World& world = *world_;
  is_started_ = true;
  phases::index(world.space, IndexAccess(world.space), world.assembly.workers);
  world.space.events.insert(world.space.events.end(), world.pending_events.begin(), world.pending_events.end());
  world.pending_events.clear();
  world.space.interventions = std::move(world.pending_interventions);
  world.pending_interventions.clear();
  finish_asked_ = phases::show(world.space, world.assembly.observers);
  flush();
}

void Simulation::reset(std::optional<std::uint64_t> seed, bool rewind) {
  World& world = *world_;
  world.failures.clear();
  world.pending_events.clear();
  world.pending_interventions.clear();
  if (start_ == nullptr) {
    unbuild(world);  // failures of controllers in destroy belong to the new run, as failures and events
  }
  logged_overflows_ = 0;
  finish_asked_ = false;
  finished_ = false;
  ++world.space.run;
  if (rewind) {
    world.space.time_before_reset = Duration::zero();
  } else {
    world.space.time_before_reset +=
        world.space.time - kEpoch + world.space.clocktick;  // one more tick, so that no stamp is used twice
  }
  if (seed) {
    world.space.seed = *seed;
    world.experiment.framework.seed = *seed;
  }
  if (start_ == nullptr) {
    restoreEngineParameters(world);
    forgetScripts(world);
    build(world);
    renewRulesInScripts(world);
  } else {
    restart(world, start_->data());
  }
  player_.restart();
  resetRules();
  for (ObserverInstance& observer : world.assembly.observers) {
    observer.is_finished = false;
    callPlugin("reset", observer.part, UserCode::kNoTick, [&] { observer->reset(); });
  }
  start();
}

RunOutcome Simulation::outcome() const {
  RunOutcome outcome{hasReachedEnd(), success(), metrics(), {}};
  for (const ControllerFailure& failure : failures()) {
    outcome.failed_robots.push_back(failure.robot);
  }
  return outcome;
}

bool Simulation::isFinished() const { return finished_ || hasReachedEnd(); }

bool Simulation::hasReachedEnd() const {
  return finish_asked_ || world_->space.tick >= world_->experiment.framework.max_clock;
}

namespace {

/// Calls all observers. One that cannot write its file must not keep the others from writing theirs.
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
  callAll(world_->assembly.observers, "flush", [](ObserverInstance& observer) { observer->flush(); });
}

void Simulation::finish() {
  finished_ = true;
  // a run that has not begun has nothing to complete, and must not change the files of an older one
  if (!is_started_) {
    return;
  }
  callAll(world_->assembly.observers, "finish", [](ObserverInstance& observer) {
    if (!observer.is_finished && !observer.is_given_up) {
      observer.is_finished = true;  // set before the call: if it does not return, the other observers are still called
      observer->finish();
    }
  });
}

void Simulation::giveUp(const std::string& part) {
  for (ObserverInstance& observer : world_->assembly.observers) {
    observer.is_given_up = observer.is_given_up || observer.part == part;
  }
  for (RuleInstance& rule : world_->assembly.rules) {
    rule.is_given_up = rule.is_given_up || rule.part == part;
  }
}

void Simulation::destroyControllers() {
  World& world = *world_;
  for (RobotInstance& instance : world.assembly.robots) {
    destroyController(world, instance);
  }
}

void Simulation::play(InterventionPlayer player) {
  SWARMANOID_EXPECTS(world_->space.tick == 0);
  player_ = std::move(player);
}

void Simulation::playInterventions(bool after_rules) {
  World& world = *world_;
  while (const RecordedIntervention* due = player_.takeDue(world.space.tick, after_rules)) {
    try {
      take(world, due->taken.what, due->taken.asked_by, after_rules);
    } catch (...) {
      throw std::runtime_error(due->location.toString() + ": <" + kindOf(due->taken.what) + "> is refused in tick " +
                               std::to_string(world.space.tick) + ": " + describeException());
    }
  }
}

void Simulation::reseed(std::uint64_t seed) {
  World& world = *world_;
  has_sensed_ = false;
  world.space.seed = seed;
  for (const auto& group : world.assembly.groups) {
    for (const auto& sensor : group->sensors) {
      sensor->reseed(seed);
    }
    for (const auto& actuator : group->actuators) {
      actuator->reseed(seed);
    }
  }
  for (RobotInstance& instance : world.assembly.robots) {
    instance.robot->reseed(seed);
  }
  for (RuleInstance& rule : world.assembly.rules) {
    rule->reseed(seed);
  }
}

void Simulation::apply(const Intervention& intervention) {
  has_sensed_ = false;
  take(*world_, intervention, "", rules_have_begun_);
}

}  // namespace swarmanoid
