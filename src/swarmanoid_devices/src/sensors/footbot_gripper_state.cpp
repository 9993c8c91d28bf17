// The gripper's contact switch: it reports whether the robot grips an object, according to the structural tree.
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid::devices {
namespace {

class FootbotGripperStateSensor final : public SensorOf<FootbotGripperState> {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = FootbotGripperState::kType;
    description.implementation = "default";
    description.is_default = true;
    description.summary = "Whether the gripper holds something.";
    return description;
  }

  void configure(const Configuration&) override {}

  void sense(const Space& space, std::size_t first, std::size_t last) override {
    for (std::size_t k = first; k < last; ++k) {
      instances_[k].readings->gripping = space.structure.grippedBy(instances_[k].row) != kNoRow;
    }
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::FootbotGripperStateSensor)
