// The magnet's contact switch.
#include "swarmanoid_interface/devices/eyebot_magnet.hpp"

#include "common/holders.hpp"

namespace swarmanoid::devices {
namespace {

class EyebotMagnetStateSensor final : public HolderSensor<EyebotMagnetStateSensor, EyebotMagnetState> {
 public:
  static constexpr auto kHolders = kMagnetHolder;

  static PluginDescription describe() {
    PluginDescription description;
    description.label = EyebotMagnetState::kType;
    description.implementation = "default";
    description.is_default = true;
    description.summary = "Whether the magnet holds on to something.";
    return description;
  }

  void sense(const Space& space, std::size_t first, std::size_t last) override {
    for (std::size_t k = first; k < last; ++k) {
      instances_[k].readings->attached = attachmentOf(space, instances_[k], 0).held != kNoRow;
    }
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::EyebotMagnetStateSensor)
