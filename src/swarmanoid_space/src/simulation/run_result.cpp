#include "swarmanoid_space/simulation/run_result.hpp"

namespace swarmanoid {

RunResult resultOf(const Simulation& simulation, const RunEnd& end) {
  const Space& space = simulation.space();
  RunResult result;
  result.experiment = simulation.experiment().name;
  result.seed = space.seed;
  result.run = space.run;
  result.ticks = space.tick;
  result.simulated_s = toSeconds(space.time - kEpoch);
  result.finished = end.finished;
  result.message = end.message;
  result.success = simulation.success();
  result.metrics = simulation.metrics();
  result.failures = simulation.failures();
  result.overflows = space.overflows;
  result.state_hash = end.state_hash ? *end.state_hash : simulation.stateHash();
  result.wall_s = end.wall_s;
  return result;
}

}  // namespace swarmanoid
