// The LEDs of any robot.
#include <algorithm>

#include "common/mechanisms.hpp"
#include "led_ring.hpp"
#include "swarmanoid_interface/devices/led_array.hpp"

namespace swarmanoid::devices {
namespace {

static_assert(Leds::kMost == EntityModel::kMaxLeds, "a robot's LEDs all have a colour");

class LedsActuator final : public LedActuator<Leds> {
 public:
  static PluginDescription describe() { return describeLeds("The coloured LEDs of the robot."); }

 protected:
  void prepareInstance(const Space& space, BasicActuatorInstance<Leds>& instance) override {
    const EntityModel& model = *space.entities.model[instance.row];
    if (model.led_positions.empty()) {
      refuseWithout(Leds::kType, model, "LEDs");
    }
    LedActuator<Leds>::prepareInstance(space, instance);
  }

  void apply(const Space& /*space*/, const ActuateAccess& access, BasicActuatorInstance<Leds>& instance) override {
    const Span<Color> leds = access.leds[instance.row];
    std::copy_n(instance.actuation->colors.begin(), leds.size(), leds.begin());
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::LedsActuator)
