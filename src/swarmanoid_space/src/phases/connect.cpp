// Phase 5: grips are made and broken, engine by engine; then state that depends on the new poses, such as laser spots,
// is updated.
#include "phases.hpp"
#include "swarmanoid_interface/process/user_code.hpp"

namespace swarmanoid::phases {

void connect(const Space& space, const ConnectAccess& access, const AfterMoveAccess& after_move,
             const std::vector<Named<Engine>>& engines, const std::vector<std::unique_ptr<ControllerGroup>>& groups) {
  for (const auto& engine : engines) {
    callPlugin("connect", engine.part, space.tick, [&] { engine->connect(space, access); });
  }
  after_move.laser_spots.clear();
  for (const auto& group : groups) {
    for (const auto& actuator : group->actuators) {
      callPlugin("afterMove", actuator.part, space.tick, [&] { actuator->afterMove(space, after_move); });
    }
  }
}

}  // namespace swarmanoid::phases
