// Part of phase 3: robots that are not commanded any more are stopped safely. Their commands take effect in this
// tick, and may take some more.
#include "phases.hpp"

namespace swarmanoid::phases {

void stopSafely(Space& space, std::vector<RobotInstance>& instances) {
  for (RobotInstance& instance : instances) {
    if (!instance.stops_since) {
      continue;
    }
    const SafeStopMoment moment{toSeconds(space.time - *instance.stops_since), {}, *instance.robot};
    bool is_over = true;
    for (const auto& actuator : instance.group->actuators) {
      is_over = actuator->stop(space, instance.row, moment) && is_over;
    }
    if (is_over) {
      instance.stops_since.reset();
    }
  }
}

}  // namespace swarmanoid::phases
