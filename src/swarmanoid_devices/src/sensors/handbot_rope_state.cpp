// The rope's encoder and tension sensor.
#include "swarmanoid_interface/devices/handbot_rope.hpp"

#include "common/holders.hpp"

namespace swarmanoid::devices {
namespace {

class HandbotRopeStateSensor final : public HolderSensor<HandbotRopeStateSensor, HandbotRopeState> {
 public:
  static constexpr auto kHolders = kRopeHolder;

  static PluginDescription describe() {
    PluginDescription description;
    description.label = HandbotRopeState::kType;
    description.implementation = "default";
    description.is_default = true;
    description.summary = "Whether the rope is attached, its length and its tension.";
    return description;
  }

  void sense(const Space& space, std::size_t first, std::size_t last) override {
    for (std::size_t k = first; k < last; ++k) {
      const Attachment rope = attachmentOf(space, instances_[k], 0);
      *instances_[k].readings = {rope.held != kNoRow, rope.length, rope.force};
    }
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::HandbotRopeStateSensor)
