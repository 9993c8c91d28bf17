#include "run.hpp"

#include <chrono>
#include <exception>
#include <stdexcept>

#include "plugins/python_rule.hpp"
#include "python/errors.hpp"
#include "python/python_scripts.hpp"
#include "python/without_lock.hpp"
#include "swarmanoid_experiment_files/interventions/intervention_file.hpp"
#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_space/intervention.hpp"

namespace py = pybind11;

namespace swarmanoid::bindings {
namespace {

/// @throws ConfigError for an unknown id of a configuration
const ControllerDescription& configurationOf(const Experiment& experiment, const std::string& id) {
  std::vector<std::string> known;
  for (const ControllerDescription& description : experiment.controllers) {
    if (description.id == id) {
      return description;
    }
    known.push_back(description.id);
  }
  throw ConfigError({experiment.file, 0}, unknownName("the controller", id, known));
}

/// Scope in which ticks are made.
class Ticking {
 public:
  Ticking(Moment& moment, bool& is_in_tick) : moment_(moment), is_in_tick_(is_in_tick) {
    ++moment_.number;  // objects from before are invalid in callbacks of these ticks, too
    moment_.is_ticking = true;
    is_in_tick_ = true;
  }
  ~Ticking() {
    ++moment_.number;
    moment_.is_ticking = false;
    is_in_tick_ = false;
  }
  Ticking(const Ticking&) = delete;
  Ticking& operator=(const Ticking&) = delete;

 private:
  Moment& moment_;
  bool& is_in_tick_;
};

}  // namespace

std::shared_ptr<Simulation> Run::makeSimulation(Experiment experiment, RunContext context, SuppliedParts parts) {
  auto simulation = std::make_shared<Simulation>(std::move(experiment), std::move(context), std::move(parts));
  simulation->start();
  return simulation;
}

Run::Run(ExperimentSource source, Experiment experiment, RunContext context, PythonParts parts, const Make& make)
    : source_(std::move(source)), parts_(std::move(parts)) {
  SuppliedParts supplied;
  for (const auto& [id, controller] : parts_.controllers) {
    const auto made = makeController(controller, configurationOf(experiment, id), moment_, thrown_);
    supplied.group_controllers[id] = made;
    holders_.push_back(std::dynamic_pointer_cast<HoldsObjects>(made));
  }
  for (const auto& [id, rule] : parts_.rules) {
    const auto made = std::make_shared<PythonRule>(rule, moment_, thrown_);
    supplied.rules.emplace_back(id, made);
    holders_.push_back(made);
  }
  supplied.scripts = makeScriptsOfPython(moment_, thrown_);
  try {
    simulation_ = make(std::move(experiment), std::move(context), std::move(supplied));
  } catch (...) {
    thrown_->raise();
    throw;
  }
  thrown_->raise();
}

template <class Action>
void Run::act(Action action) {
  std::exception_ptr stopped;
  {
    const Ticking ticking(*moment_, is_in_tick_);
    try {
      action();
    } catch (...) {
      stopped = std::current_exception();
    }
  }
  if (stopped) {
    try {
      simulation_->finish();
    } catch (...) {
      // ignored: the first error is reported
    }
  }
  thrown_->raise();
  if (stopped) {
    std::rethrow_exception(stopped);
  }
}

void Run::requireIdle() const {
  if (is_in_tick_) {
    throw std::runtime_error("the simulation is making ticks: this can be done before or after them");
  }
}

void Run::requireOpen() const {
  requireIdle();
  if (is_closed_) {
    throw std::runtime_error("the simulation is closed");
  }
}

const Simulation& Run::simulation() const {
  requireIdle();
  return *simulation_;
}

Robots Run::robots() const { return robotsOf(simulation().space(), moment_); }

Robots Run::entities() const { return entitiesOf(simulation().space(), moment_); }

std::uint64_t Run::makeTicks(std::uint64_t count) {
  constexpr std::chrono::milliseconds kBetweenSignals{50};
  auto next_look = std::chrono::steady_clock::now() + kBetweenSignals;
  std::uint64_t made = 0;
  while (made < count && !simulation_->isFinished()) {
    simulation_->tick();
    ++made;
    if (thrown_->error || WithoutLock::mustEnd()) {
      break;
    }
    if (std::chrono::steady_clock::now() >= next_look) {
      const py::gil_scoped_acquire lock;
      if (PyErr_CheckSignals() != 0) {
        thrown_->error.emplace();
        break;
      }
      next_look = std::chrono::steady_clock::now() + kBetweenSignals;
    }
  }
  return made;
}

std::uint64_t Run::tick(std::uint64_t count) {
  requireOpen();
  std::uint64_t made = 0;
  act([&] {
    const WithoutLock unlocked;
    made = makeTicks(count);
  });
  return made;
}

void Run::actUnlocked(const std::function<void()>& action) {
  requireOpen();
  act([&] {
    const WithoutLock unlocked;
    action();
  });
}

Robots Run::robotsIn(const std::shared_ptr<RobotSelection>& selection) const {
  return {simulation().space(), moment_, selection};
}

void Run::sense() {
  requireOpen();
  act([&] {
    const WithoutLock unlocked;
    simulation_->sense();
  });
}

void Run::reset(std::optional<std::uint64_t> seed) {
  requireOpen();
  act([&] { simulation_->reset(seed); });
}

std::shared_ptr<const Snapshot> Run::snapshot() const {
  requireOpen();
  return simulation_->snapshot();
}

void Run::restore(const Snapshot& snapshot) {
  requireOpen();
  std::exception_ptr refusal;
  act([&] {
    try {
      simulation_->restore(snapshot);
    } catch (const ConfigError&) {
      refusal = std::current_exception();
    }
  });
  if (refusal) {
    std::rethrow_exception(refusal);
  }
}

std::unique_ptr<Run> Run::fork() const {
  const auto snapshot = this->snapshot();
  const py::object copy = py::module_::import("copy").attr("deepcopy");
  PythonParts parts = parts_;
  for (auto& [id, controller] : parts.controllers) {
    controller = copy(controller);
  }
  for (auto& [id, rule] : parts.rules) {
    rule = copy(rule);
  }
  ExperimentSource source = source_;
  source.may_write = false;
  RunContext context;
  context.is_open = false;
  auto run = std::make_unique<Run>(source, read(source), context, std::move(parts));
  run->restore(*snapshot);
  return run;
}

void Run::apply(const Intervention& intervention) {
  requireOpen();
  std::optional<std::string> refusal;
  act([&] {
    try {
      simulation_->apply(intervention);
    } catch (const ConfigError& error) {
      refusal = error.what();
    }
  });
  if (refusal) {
    throw InterventionError(std::string(kindOf(intervention)) + " is refused: " + *refusal);
  }
}

int Run::visitObjects(visitproc visit, void* argument) const {
  for (const auto& [id, controller] : parts_.controllers) {
    if (const int result = visit(controller.ptr(), argument); result != 0) {
      return result;
    }
  }
  for (const auto& [id, rule] : parts_.rules) {
    if (const int result = visit(rule.ptr(), argument); result != 0) {
      return result;
    }
  }
  for (const auto& holder : holders_) {
    if (const int result = holder->visitObjects(visit, argument); result != 0) {
      return result;
    }
  }
  return 0;
}

void Run::releaseObjects() {
  parts_ = {};
  for (const auto& holder : holders_) {
    holder->releaseObjects();
  }
}

void Run::close() {
  requireIdle();
  if (!is_closed_) {
    ++moment_->number;
    is_closed_ = true;
    simulation_->finish();
    simulation_->destroyControllers();
  }
}

}  // namespace swarmanoid::bindings
