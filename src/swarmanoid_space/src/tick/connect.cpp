// Phase 5: grips are made and broken, engine by engine; then what hangs on the new poses, such as laser spots.
#include "tick.hpp"

namespace swarmanoid::phases {

void connect(Space& space, const std::vector<std::shared_ptr<Engine>>& engines,
             const std::vector<std::unique_ptr<ControllerGroup>>& groups) {
  for (const auto& engine : engines) {
    engine->connect(space);
  }
  space.laser_spots.clear();
  for (const auto& group : groups) {
    for (const auto& actuator : group->actuators) {
      actuator->afterMove(space);
    }
  }
}

}  // namespace swarmanoid::phases
