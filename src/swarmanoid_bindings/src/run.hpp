/// A simulation, with what Python needs besides: the moment, and what a controller in Python has thrown.
///
/// Threads  under Python's lock, which `tick` gives up while it makes ticks.
#pragma once

#include <pybind11/pybind11.h>

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "moment.hpp"
#include "robots.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid::bindings {

/// What is thrown in a step, kept until the tick is over.
struct Thrown {
  std::optional<pybind11::error_already_set> error;
};

class Run {
 public:
  /// @param controllers in Python, by the id of their configuration
  /// @throws ConfigError
  Run(Experiment experiment, RunContext context, const std::map<std::string, pybind11::object>& controllers);
  ~Run() { ++moment_->number; }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  /// Makes up to `count` ticks. @return how many: less if the run is over
  /// @throws pybind11::error_already_set what a controller threw, or Ctrl-C; std::exception what stops a run
  std::uint64_t tick(std::uint64_t count);
  void reset(std::optional<std::uint64_t> seed);
  /// Completes what observers write, and destroys the controllers.
  void close();

  /// @throws std::runtime_error while ticks are made, by another thread or around a controller
  const Simulation& simulation() const;
  Robots robots() const;
  Robots entities() const;

 private:
  /// @throws std::runtime_error
  void requireIdle() const;
  std::uint64_t makeTicks(std::uint64_t count);

  std::shared_ptr<Moment> moment_ = std::make_shared<Moment>();
  std::shared_ptr<Thrown> thrown_ = std::make_shared<Thrown>();
  std::unique_ptr<Simulation> simulation_;
  bool is_in_tick_ = false;
  bool is_closed_ = false;
};

}  // namespace swarmanoid::bindings
