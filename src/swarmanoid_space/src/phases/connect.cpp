// Phase 5: grips are made and broken, engine by engine; then state that depends on the new poses, such as laser spots,
// is updated.
#include "phases.hpp"
#include "swarmanoid_interface/process/user_code.hpp"

namespace swarmanoid::phases {

void connect(Space& space, const std::vector<Named<Engine>>& engines,
             const std::vector<std::unique_ptr<ControllerGroup>>& groups) {
  for (const auto& engine : engines) {
    callPlugin("connect", engine.part, space.tick, [&] { engine->connect(space); });
  }
  space.laser_spots.clear();
  for (const auto& group : groups) {
    for (const auto& actuator : group->actuators) {
      callPlugin("afterMove", actuator.part, space.tick, [&] { actuator->afterMove(space); });
    }
  }
}

}  // namespace swarmanoid::phases
