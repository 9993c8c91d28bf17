// Part of phase 3: robots that are no longer commanded are stopped safely. The commands of a safe stop take effect in
// this tick, and may continue for some more.
#include "phases.hpp"

namespace swarmanoid::phases {

void stopSafely(const Space& space, const ActuateAccess& access, std::vector<RobotInstance>& instances) {
  for (RobotInstance& instance : instances) {
    if (!instance.stops_since) {
      continue;
    }
    const SafeStopMoment moment{toSeconds(space.time - *instance.stops_since), {}, *instance.robot};
    bool is_over = true;
    for (const auto& actuator : instance.group->actuators) {
      is_over = actuator->stop(space, access, instance.row, moment) && is_over;
    }
    if (is_over) {
      instance.stops_since.reset();
    }
  }
}

}  // namespace swarmanoid::phases
