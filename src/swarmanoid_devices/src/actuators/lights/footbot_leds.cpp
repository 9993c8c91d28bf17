// The footbot's ring of LEDs.
#include "led_ring.hpp"

namespace swarmanoid::devices {
namespace {

class FootbotLedsActuator final : public LedRingActuator<FootbotLeds> {
 public:
  static PluginDescription describe() { return describeRing(); }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::FootbotLedsActuator)
