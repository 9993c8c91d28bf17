#include "swarmanoid_experiment_files/without_ros.hpp"

namespace swarmanoid {

void refuseRobotsOfOthers(const Experiment& experiment) {
  for (const EntityDescription& entity : experiment.arena.entities) {
    if (isOfOthers(entity.source)) {
      throw ConfigError(entity.location, "'" + entity.id + "' is commanded by another process (source=\"" +
                                             toString(entity.source) +
                                             "\"), which needs ROS; allowed: roslaunch, or another source");
    }
  }
}

}  // namespace swarmanoid
