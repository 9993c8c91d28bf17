// The footbot's ring of LEDs as a pointer.
#include "swarmanoid_interface/devices/footbot_preferential_direction.hpp"

#include "led_ring.hpp"

namespace swarmanoid::devices {
namespace {

class FootbotPreferentialDirectionActuator final : public LedActuator<FootbotPreferentialDirection> {
 public:
  static PluginDescription describe() {
    return describeLeds("The three LEDs nearest to the direction in one colour, the others in another.");
  }

 protected:
  void apply(const Space& /*space*/, const ActuateAccess& access,
             BasicActuatorInstance<FootbotPreferentialDirection>& instance) override {
    const Span<Color> leds = access.leds[instance.row];
    for (std::size_t k = 0; k < leds.size(); ++k) {
      leds[k] = instance.actuation->colorOf(k, leds.size());
    }
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::FootbotPreferentialDirectionActuator)
