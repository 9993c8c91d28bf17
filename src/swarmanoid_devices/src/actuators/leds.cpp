// The LEDs of any robot.
#include <algorithm>

#include "mechanisms.hpp"
#include "swarmanoid_interface/devices/led_array.hpp"
#include "swarmanoid_space/actuator.hpp"

namespace swarmanoid::devices {
namespace {

static_assert(Leds::kMost == EntityModel::kMaxLeds, "a robot's LEDs all have a colour");

class LedsActuator final : public ActuatorOf<Leds> {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = Leds::kType;
    description.implementation = "default";
    description.is_default = true;
    description.summary = "The coloured LEDs of the robot.";
    return description;
  }

  void configure(const Configuration&) override {}

 protected:
  void prepareInstance(const Space& space, BasicActuatorInstance<Leds>& instance) override {
    const EntityModel& model = *space.entities.model[instance.row];
    if (model.led_positions.empty()) {
      refuseWithout(Leds::kType, model, "LEDs");
    }
  }

  void apply(Space& space, BasicActuatorInstance<Leds>& instance) override {
    const Span<Color> leds = space.leds[instance.row];
    std::copy_n(instance.actuation->colors.begin(), leds.size(), leds.begin());
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::LedsActuator)
