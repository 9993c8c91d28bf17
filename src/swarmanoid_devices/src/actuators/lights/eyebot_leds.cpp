// The eyebot's ring of LEDs.
#include "led_ring.hpp"

namespace swarmanoid::devices {
namespace {

class EyebotLedsActuator final : public LedRingActuator<EyebotLeds> {
 public:
  static PluginDescription describe() { return describeRing(); }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::EyebotLedsActuator)
