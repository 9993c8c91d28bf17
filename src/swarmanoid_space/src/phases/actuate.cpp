// Phase 3: commands are checked, disturbed by their errors, and limited.
#include "phases.hpp"
#include "swarmanoid_interface/process/user_code.hpp"

namespace swarmanoid::phases {

void actuate(const Space& space, const ActuateAccess& access,
             const std::vector<std::unique_ptr<ControllerGroup>>& groups, std::vector<Row>& faulty,
             const Workers& workers) {
  faulty.clear();
  for (const auto& group : groups) {
    for (const auto& actuator : group->actuators) {
      callPlugin("actuate", actuator.part, space.tick, [&] { actuator->actuate(space, access, faulty, workers); });
    }
  }
}

}  // namespace swarmanoid::phases
