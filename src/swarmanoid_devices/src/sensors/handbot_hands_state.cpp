// The docking sensors of the hands.
#include "swarmanoid_interface/devices/handbot_hands.hpp"

#include "common/holders.hpp"

namespace swarmanoid::devices {
namespace {

class HandbotHandsStateSensor final : public HolderSensor<HandbotHandsStateSensor, HandbotHandsState, 2> {
 public:
  static constexpr auto kHolders = kHandHolders;

  static PluginDescription describe() {
    PluginDescription description;
    description.label = HandbotHandsState::kType;
    description.implementation = "default";
    description.is_default = true;
    description.summary = "Whether each hand holds something, and the force on it.";
    return description;
  }

  void sense(const Space& space, std::size_t first, std::size_t last) override {
    for (std::size_t k = first; k < last; ++k) {
      const Attachment left = attachmentOf(space, instances_[k], 0);
      const Attachment right = attachmentOf(space, instances_[k], 1);
      instances_[k].readings->left = {left.held != kNoRow, left.force};
      instances_[k].readings->right = {right.held != kNoRow, right.force};
    }
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::HandbotHandsStateSensor)
