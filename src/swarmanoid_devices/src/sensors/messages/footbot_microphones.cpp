// The footbot's four microphones.
#include "swarmanoid_interface/devices/footbot_microphones.hpp"

#include "microphone_array.hpp"

namespace swarmanoid::devices {
namespace {

class FootbotMicrophonesSensor final
    : public MicrophoneArray<FootbotMicrophonesSensor, FootbotMicrophones, FootbotMicrophones::kCount> {
 public:
  static PluginDescription describe() {
    return describeArray("Four microphones around the body; sound falls by the inverse square law.");
  }

  static float& levelOf(Instance& instance, std::size_t i) { return instance.readings->level[i]; }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::FootbotMicrophonesSensor)
