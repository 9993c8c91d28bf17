/// Base classes of actuators that show colours on a robot's LEDs: they write the colours to the space, from which
/// cameras and light sensors read them. Each such device, a ring or another modality of access to the LEDs (thesis
/// 3.3), writes all LEDs in each tick, so a robot has at most one of them.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "swarmanoid_interface/devices/leds.hpp"
#include "swarmanoid_space/actuator.hpp"

namespace swarmanoid::devices {

/// All device types that write LEDs; a robot may have one of them.
constexpr std::array<const char*, 6> kLedDevices{
    "eyebot_leds", "footbot_beacon", "footbot_leds", "footbot_preferential_direction", "handbot_leds", "leds"};

constexpr bool isLedDevice(std::string_view type) {
  for (const char* device : kLedDevices) {
    if (type == device) {
      return true;
    }
  }
  return false;
}

/// @throws ConfigError if the robot has another device for its LEDs
inline void refuseSecondLeds(const Space& space, Row row, const std::string& type) {
  for (const char* other : kLedDevices) {
    if (type != other && space.actuation.find(other, row) != nullptr) {
      throw ConfigError({}, "found the devices '" + std::string(other) + "' and '" + type +
                                "' on one robot, allowed: one that shows its LEDs");
    }
  }
}

template <class Leds>
class LedActuator : public ActuatorOf<Leds> {
  static_assert(isLedDevice(Leds::kType), "kLedDevices names it");

 public:
  void configure(const Configuration&) override {}

 protected:
  static PluginDescription describeLeds(const std::string& summary) {
    PluginDescription description;
    description.label = Leds::kType;
    description.implementation = "default";
    description.is_default = true;
    description.summary = summary;
    return description;
  }

  void prepareInstance(const Space& space, BasicActuatorInstance<Leds>& instance) override {
    refuseSecondLeds(space, instance.row, Leds::kType);
  }
};

/// `Leds` has `std::array<Color, kCount> ring`.
template <class Leds>
class LedRingActuator : public LedActuator<Leds> {
 protected:
  static PluginDescription describeRing() {
    return LedActuator<Leds>::describeLeds(std::string("The ring of coloured LEDs of the ") + Leds::kRobot + ".");
  }

  void apply(const Space& /*space*/, const ActuateAccess& access, BasicActuatorInstance<Leds>& instance) override {
    const Span<Color> leds = access.leds[instance.row];  // a robot may have fewer than the device
    std::copy_n(instance.actuation->ring.begin(), std::min(leds.size(), Leds::kCount), leds.begin());
  }
};

}  // namespace swarmanoid::devices
