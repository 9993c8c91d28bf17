// The footbot's ring of LEDs as a beacon.
#include "swarmanoid_interface/devices/footbot_beacon.hpp"

#include <algorithm>

#include "led_ring.hpp"

namespace swarmanoid::devices {
namespace {

class FootbotBeaconActuator final : public LedActuator<FootbotBeacon> {
 public:
  static PluginDescription describe() { return describeLeds("All LEDs of the ring in one colour."); }

 protected:
  void apply(const Space& /*space*/, const ActuateAccess& access,
             BasicActuatorInstance<FootbotBeacon>& instance) override {
    const Span<Color> leds = access.leds[instance.row];
    std::fill(leds.begin(), leds.end(), instance.actuation->color);
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::FootbotBeaconActuator)
