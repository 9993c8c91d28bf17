/// One world of agents for Env and ParallelEnv: a Worlds with a single world, together with the Simulation of that
/// world, so that metrics, interventions, rules in Python and files of observers are those of any other run.
///
/// Arrays   float32, [slots][numbers], copies.
/// Threads  the GIL must be held; steps and resets release it.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "run_options.hpp"
#include "swarmanoid_space/worlds/worlds.hpp"

namespace swarmanoid::bindings {

class AgentWorld {
 public:
  using Array = pybind11::array_t<float>;

  /// @param options count is 1, autoreset kDisabled @throws as of Run and Worlds
  AgentWorld(Worlds::Options options, const RunOptions& run);

  /// The run of the world. Its ticks and resets apply here, too, before the next step.
  Run& run() { return *run_; }

  /// @param actions (slots, numbers), converted from any numbers
  /// @return (observations, whether a rule has ended the run or no agent remains, whether the last tick was made)
  /// @throws pybind11::value_error for another shape; else as Run::tick
  pybind11::tuple step(const pybind11::object& actions);
  void reset(std::optional<std::uint64_t> seed);
  /// Observations of the next tick: those of the last step, unless the run has changed since.
  Array observations();
  pybind11::array_t<bool> present() const;
  /// Agents that are present, in the order of their slots.
  Robots robots();
  /// Ticks and metrics.
  pybind11::dict info() const;
  std::size_t slots() const { return worlds_->slots(); }
  const Worlds& worlds() const { return *worlds_; }

  /// HoldsObjects for the run. @{
  int visitObjects(visitproc visit, void* argument) const { return run_->visitObjects(visit, argument); }
  void releaseObjects() { run_->releaseObjects(); }
  /// @}

 private:
  /// Renews the arrays of the worlds if the run was ticked, reset or changed from outside since the last step or look.
  void look();

  std::shared_ptr<Worlds> worlds_;
  std::unique_ptr<Run> run_;
  std::vector<double> actions_;                // of the last step: ticks from outside repeat them
  std::uint64_t looked_at_ = 0;                // number of the moment
  std::shared_ptr<RobotSelection> selection_;  // of the robots that were asked for last
  std::vector<EntityNumber> numbers_;          // of these robots
};

void bindAgentWorld(pybind11::module_& module);

}  // namespace swarmanoid::bindings
