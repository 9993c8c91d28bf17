// The docking sensors of the hands.
#include "swarmanoid_interface/devices/handbot_hands.hpp"

#include "mechanisms.hpp"
#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid::devices {
namespace {

class HandbotHandsStateSensor final : public SensorOf<HandbotHandsState> {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = HandbotHandsState::kType;
    description.implementation = "default";
    description.is_default = true;
    description.summary = "Whether each hand holds something, and the force on it.";
    description.robots = {"handbot"};
    return description;
  }

  void configure(const Configuration&) override {}

  void sense(const Space& space, std::size_t first, std::size_t last) override {
    for (std::size_t k = first; k < last; ++k) {
      const Row row = instances_[k].row;
      const Attachment left = attachmentOf(space, row, "left hand");
      const Attachment right = attachmentOf(space, row, "right hand");
      instances_[k].readings->left = {left.held != kNoRow, left.force};
      instances_[k].readings->right = {right.held != kNoRow, right.force};
    }
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::HandbotHandsStateSensor)
