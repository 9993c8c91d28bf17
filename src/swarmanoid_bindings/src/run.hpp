/// A simulation with additional state for Python: the current moment, and exceptions of Python controllers.
///
/// Threads  the GIL must be held; `tick` and `sense` release it while the simulation works.
#pragma once

#include <pybind11/pybind11.h>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiment_source.hpp"
#include "moment.hpp"
#include "python/holds_objects.hpp"
#include "python/thrown.hpp"
#include "robots.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid::bindings {

/// Python controllers and rules, by id.
struct PythonParts {
  std::map<std::string, pybind11::object> controllers;          ///< replace the controllers of configurations
  std::vector<std::pair<std::string, pybind11::object>> rules;  ///< in addition to those of the experiment file
};

class Run {
 public:
  /// Makes the simulation of a run, and starts it.
  using Make =
      std::function<std::shared_ptr<Simulation>(Experiment experiment, RunContext context, SuppliedParts parts)>;

  /// @throws ConfigError, pybind11::error_already_set for exceptions of Python parts
  /// @param source of the experiment, for `fork`
  Run(ExperimentSource source, Experiment experiment, RunContext context, PythonParts parts,
      const Make& make = &Run::makeSimulation);
  ~Run() { ++moment_->number; }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  /// Makes up to `count` ticks. @return number of ticks made; less if the run ends
  /// @throws pybind11::error_already_set for an exception of a controller or a rule, and for Ctrl-C; std::exception for
  /// other errors. The run can continue only after exceptions of controllers and after Ctrl-C.
  std::uint64_t tick(std::uint64_t count);
  /// Computes the readings that controllers get in the next tick (Simulation::sense).
  void sense();
  void reset(std::optional<std::uint64_t> seed);
  /// @throws std::runtime_error naming the part without a defined state
  std::shared_ptr<const Snapshot> snapshot() const;
  /// @throws ConfigError for a snapshot of another experiment; the run is then unchanged
  void restore(const Snapshot& snapshot);
  /// Another run of the same experiment, without observers, with copies of the Python parts, in the state of this one.
  std::unique_ptr<Run> fork() const;
  /// @throws InterventionError with the reason if the intervention is rejected; the world is then unchanged
  void apply(const Intervention& intervention);
  /// Completes the output of observers, and destroys the controllers.
  void close();
  /// Calls action() without the GIL; it may make ticks, sense or reset. Exceptions as of `tick`.
  void actUnlocked(const std::function<void()>& action);
  /// Number that grows with each tick, reset and intervention.
  std::uint64_t momentNumber() const { return moment_->number; }
  /// The robots of some rows, in their order. @param selection kept while the rows stay the same
  Robots robotsIn(const std::shared_ptr<RobotSelection>& selection) const;

  /// @throws std::runtime_error while ticks are made, by another thread or by a caller of the current controller
  const Simulation& simulation() const;
  Robots robots() const;
  Robots entities() const;

  /// HoldsObjects for all controllers and rules of the run. @{
  int visitObjects(visitproc visit, void* argument) const;
  void releaseObjects();
  /// @}

 private:
  static std::shared_ptr<Simulation> makeSimulation(Experiment experiment, RunContext context, SuppliedParts parts);
  /// @throws std::runtime_error
  void requireIdle() const;
  void requireOpen() const;
  std::uint64_t makeTicks(std::uint64_t count);
  /// Runs an action that may call Python code. Rethrows exceptions of that code, and errors that stop the run.
  template <class Action>
  void act(Action action);

  ExperimentSource source_;
  PythonParts parts_;
  std::shared_ptr<Moment> moment_ = std::make_shared<Moment>();
  std::shared_ptr<Thrown> thrown_ = std::make_shared<Thrown>();
  std::vector<std::shared_ptr<HoldsObjects>> holders_;  // controllers and rules
  std::shared_ptr<Simulation> simulation_;
  bool is_in_tick_ = false;
  bool is_closed_ = false;
};

}  // namespace swarmanoid::bindings
