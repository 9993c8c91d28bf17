/// A ring of LEDs: it writes its colours to the space, from which cameras read them.
#pragma once

#include <algorithm>
#include <string>

#include "swarmanoid_interface/devices/leds.hpp"
#include "swarmanoid_space/actuator.hpp"

namespace swarmanoid::devices {

template <class Leds>
class LedRingActuator : public ActuatorOf<Leds> {
 public:
  void configure(const Configuration&) override {}

 protected:
  static PluginDescription describeRing() {
    PluginDescription description;
    description.label = Leds::kType;
    description.implementation = "default";
    description.is_default = true;
    description.summary = std::string("The ring of coloured LEDs of the ") + Leds::kRobot + ".";
    return description;
  }

  void apply(Space& space, BasicActuatorInstance<Leds>& instance) override {
    const Span<Color> leds = space.leds[instance.row];  // a robot may have fewer than the device
    std::copy_n(instance.actuation->ring.begin(), std::min(leds.size(), Leds::kCount), leds.begin());
  }
};

}  // namespace swarmanoid::devices
