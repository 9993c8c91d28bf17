// The handbot's ring of LEDs.
#include "swarmanoid_interface/devices/handbot_leds.hpp"

#include "led_ring.hpp"

namespace swarmanoid::devices {
namespace {

class HandbotLedsActuator final : public LedRingActuator<HandbotLeds> {
 public:
  static PluginDescription describe() { return describeRing(); }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::HandbotLedsActuator)
