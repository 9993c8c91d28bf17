// Part of phase 3: robots that nobody commands any more are stopped safely. What they are told takes effect in this
// tick, and may take some more.
#include "phases.hpp"

namespace swarmanoid::phases {

void stopSafely(Space& space, std::vector<Driver>& drivers) {
  for (Driver& driver : drivers) {
    if (!driver.stops_since) {
      continue;
    }
    const SafeStopMoment moment{toSeconds(space.time - *driver.stops_since), {}, *driver.robot};
    bool is_over = true;
    for (const auto& actuator : driver.group->actuators) {
      is_over = actuator->stop(space, driver.row, moment) && is_over;
    }
    if (is_over) {
      driver.stops_since.reset();
    }
  }
}

}  // namespace swarmanoid::phases
