// An external tracking system: it reports the pose of a robot in the space.
#include "swarmanoid_interface/devices/positioning.hpp"

#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid::devices {
namespace {

class PositioningSensor final : public SensorOf<Positioning> {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = Positioning::kType;
    description.implementation = "default";
    description.is_default = true;
    description.summary = "The pose in the space, which engines and other sensors use.";
    return description;
  }

  void configure(const Configuration& /*parameters*/) override {}

  void sense(const Space& space, std::size_t first, std::size_t last) override {
    for (std::size_t k = first; k < last; ++k) {
      const Pose& pose = space.entities.pose[instances_[k].row];
      *instances_[k].readings = Positioning::reading(pose.position, pose.orientation);
    }
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::PositioningSensor)
