// Phase 3: commands are checked, limited and given noise.
#include "tick.hpp"

namespace swarmanoid::phases {

void actuate(Space& space, const std::vector<std::unique_ptr<ControllerGroup>>& groups, std::vector<Row>& faulty) {
  faulty.clear();
  for (const auto& group : groups) {
    for (const auto& actuator : group->actuators) {
      actuator->actuate(space, faulty);
    }
  }
}

}  // namespace swarmanoid::phases
