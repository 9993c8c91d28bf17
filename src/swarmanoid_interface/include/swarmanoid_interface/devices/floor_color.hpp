/// Sensor: the colour of the floor under any robot.
#pragma once

#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid {

/// One spot that distinguishes colours; ground sensors (devices/ground.hpp) read brightness only. The sensor sits at
/// the link `floor_color` of the robot's description and looks along the link's x axis. On a robot without that link it
/// is kHeight above the origin and looks straight down along the robot's z axis.
struct FloorColor {
  static constexpr const char* kType = "floor_color";
  static constexpr const char* kLink = "floor_color";
  static constexpr double kHeight = 0.005;     ///< [m]
  static constexpr double kUsualRange = 0.05;  ///< maximum distance of the ground along the line of sight [m]

  Color color;  ///< black for a black floor, or with no ground in range
};

template <class Visitor>
void fields(Visitor& visit, FloorColor& floor) {
  visit(floor.color, {"color", "", "of the floor; black with no ground in range"});
}
REGISTER_DEVICE_OF_SUITE(FloorColor, kSensor, "The colour of the floor under the robot.")

}  // namespace swarmanoid
