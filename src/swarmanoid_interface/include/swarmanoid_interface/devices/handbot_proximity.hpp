/// Sensor: the infrared proximity sensors in a handbot's palms, which look along the hands (thesis 1: "precise gripping
/// along with obstacle avoidance will be done thanks to several proximity sensors").
#pragma once

#include "swarmanoid_interface/devices/proximity.hpp"

namespace swarmanoid {

/// Readings by the law of Proximity::response. The sensors sit between the cups of the hands, at the links left_suction
/// and right_suction of the robot's description, and move with the arms.
struct HandbotProximity {
  static constexpr const char* kType = "handbot_proximity";
  static constexpr const char* kRobot = "handbot";

  float left = 0.0F;
  float right = 0.0F;
};

template <class Visitor>
void fields(Visitor& visit, HandbotProximity& proximity) {
  visit(proximity.left, {"left", "", "0 without an object in range, 1 at contact", {0.0, 1.0}});
  visit(proximity.right, {"right", "", "the same of the right hand", {0.0, 1.0}});
}
REGISTER_DEVICE_OF_SUITE(HandbotProximity, kSensor, "Infrared proximity sensors in the palms.")

}  // namespace swarmanoid
