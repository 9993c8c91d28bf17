/// Sensor: the vacuum that the pumps of a handbot's hands reach in each of the suction cups (thesis 1, figure 1.2: two
/// or four a hand).
#pragma once

#include <array>
#include <cstddef>

#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid {

/// Vacuum in each cup, as a fraction of the vacuum in a cup whose whole lip lies on a surface; 0 while the suction is
/// off (HandbotHands) or with no surface there. Cups are numbered from the left of each hand, as the links left_cup_0,
/// left_cup_1, ... of the robot's description; cups that the robot does not have read 0.
struct HandbotVacuum {
  static constexpr const char* kType = "handbot_vacuum";
  static constexpr const char* kRobot = "handbot";
  static constexpr std::size_t kMostCups = 4;   ///< per hand
  static constexpr double kCupRadius = 0.011;   ///< of a cup's lip [m]
  static constexpr double kReach = 0.01;        ///< a surface this close to the lip, on either side, closes the cup [m]
  static constexpr std::size_t kLipPoints = 8;  ///< points of the lip that are checked, evenly spaced

  std::array<float, kMostCups> left{};
  std::array<float, kMostCups> right{};
};

template <class Visitor>
void fields(Visitor& visit, HandbotVacuum& vacuum) {
  visit(vacuum.left,
        {"left", "", "of each cup: 1 where it lies on a surface all round, 0 with suction off", {0.0, 1.0}});
  visit(vacuum.right, {"right", "", "the same of the right hand", {0.0, 1.0}});
}
REGISTER_DEVICE_OF_SUITE(HandbotVacuum, kSensor, "The vacuum in each suction cup of the hands.")

}  // namespace swarmanoid
