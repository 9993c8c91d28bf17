/// A simulation, with what Python needs besides: the moment, and what a controller in Python has thrown.
///
/// Threads  under Python's lock, which `tick` gives up while it makes ticks.
#pragma once

#include <pybind11/pybind11.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "holds_objects.hpp"
#include "moment.hpp"
#include "robots.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"
#include "thrown.hpp"

namespace swarmanoid::bindings {

/// Parts in Python, by id.
struct PythonParts {
  std::map<std::string, pybind11::object> controllers;          ///< instead of those of the configurations
  std::vector<std::pair<std::string, pybind11::object>> rules;  ///< beside those of the experiment file
};

class Run {
 public:
  /// @throws ConfigError, pybind11::error_already_set what a part in Python throws
  Run(Experiment experiment, RunContext context, const PythonParts& parts);
  ~Run() { ++moment_->number; }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  /// Makes up to `count` ticks. @return how many: less if the run is over
  /// @throws pybind11::error_already_set what a controller or a rule threw, or Ctrl-C; std::exception what stops a run.
  /// After all but what controllers throw, and Ctrl-C, the run is over
  std::uint64_t tick(std::uint64_t count);
  /// Readings as controllers get them in the next tick (Simulation::sense).
  void sense();
  void reset(std::optional<std::uint64_t> seed);
  /// @throws InterventionError why it is refused; then nothing has changed
  void apply(const Intervention& intervention);
  /// Completes what observers write, and destroys the controllers.
  void close();

  /// @throws std::runtime_error while ticks are made, by another thread or around a controller
  const Simulation& simulation() const;
  Robots robots() const;
  Robots entities() const;

  /// Of its controllers and rules, as of HoldsObjects. @{
  int visitObjects(visitproc visit, void* argument) const;
  void releaseObjects();
  /// @}

 private:
  /// @throws std::runtime_error
  void requireIdle() const;
  void requireOpen() const;
  std::uint64_t makeTicks(std::uint64_t count);
  /// Does something to the run that may call code in Python. What that throws, and what stops the run, is thrown here.
  template <class Action>
  void act(Action action);

  std::shared_ptr<Moment> moment_ = std::make_shared<Moment>();
  std::shared_ptr<Thrown> thrown_ = std::make_shared<Thrown>();
  std::vector<std::shared_ptr<HoldsObjects>> holders_;  // controllers and rules
  std::unique_ptr<Simulation> simulation_;
  bool is_in_tick_ = false;
  bool is_closed_ = false;
};

}  // namespace swarmanoid::bindings
