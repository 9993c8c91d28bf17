/// A running world: the space, and everything that acts on it. Simulation owns it, and interventions change it.
///
/// Threads  see Simulation.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "../assembly/assembly.hpp"
#include "swarmanoid_space/lockstep/lockstep.hpp"
#include "swarmanoid_space/world/controller_failure.hpp"
#include "swarmanoid_space/world/supplied_parts.hpp"

namespace swarmanoid {

struct World {
  World(Experiment experiment_of_run, RunContext context_of_run, SuppliedParts parts)
      : experiment(std::move(experiment_of_run)),
        context(std::move(context_of_run)),
        supplied(std::move(parts)),
        assembly(experiment.framework.threads, space.entities.columns) {
    context.experiment = &experiment;
    space.seed = experiment.framework.seed;
  }

  Experiment experiment;
  RunContext context;
  SuppliedParts supplied;
  Space space;
  Assembly assembly;  ///< engines, robots, rules, observers
  Lockstep lockstep;  ///< commands from other processes
  /// Parameters of engines that were changed during the run, in the order of Space::engines; null: those of the file.
  std::vector<std::shared_ptr<const Configuration>> engine_parameters;
  std::vector<Event> pending_events;                     ///< of the next tick
  std::vector<TakenIntervention> pending_interventions;  ///< of the next tick
  InterventionQueue queue;                               ///< requests of rules
  std::vector<AskedIntervention> asked;                  ///< scratch of takeAsked
  std::vector<ControllerFailure> failures;
  Robot::LogSink log_sink;
};

}  // namespace swarmanoid
