/// Actuator: a footbot as a beacon, its whole ring of LEDs in one colour. It is the ring of FootbotLeds, commanded in
/// another way (thesis 3.3), so a robot has one of the two.
#pragma once

#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid {

struct FootbotBeacon {
  static constexpr const char* kType = "footbot_beacon";
  static constexpr const char* kRobot = "footbot";

  Color color;  ///< of all LEDs; black: they are off
};

template <class Visitor>
void fields(Visitor& visit, FootbotBeacon& beacon) {
  visit(beacon.color, {"color", "", "of all LEDs; black: they are off"});
}
/// The LEDs keep their colour.
inline bool stopSafely(FootbotBeacon& /*beacon*/, const SafeStopMoment& /*moment*/) { return true; }
REGISTER_DEVICE_OF_SUITE(FootbotBeacon, kActuator, "The ring of LEDs, all in one colour.")

}  // namespace swarmanoid
