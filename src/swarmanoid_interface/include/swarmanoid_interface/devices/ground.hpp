/// Sensor: infrared spots under any robot, as many as it has. Each reads the reflectance of the floor under it.
#pragma once

#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/span.hpp"

namespace swarmanoid {

/// The reading and the position of one spot.
struct GroundSpot {
  float value = 0.0F;  ///< 0 over black or with no ground in range, 1 over white
  float x = 0.0F;      ///< position in the robot's frame, ahead [m]
  float y = 0.0F;      ///< position in the robot's frame, to the left [m]
};

template <class Visitor>
void fields(Visitor& visit, GroundSpot& spot) {
  visit(spot.value, {"value", "", "0 over black or with no ground in range, 1 over white", {0.0, 1.0}});
  visit(spot.x, {"x", "m", "where the spot is in the robot's frame, ahead"});
  visit(spot.y, {"y", "m", "where the spot is in the robot's frame, to the left"});
}

/// Readings in the order of the spots: that of the links ground_0, ground_1, ... of the robot's description. A spot
/// looks along its link's x axis, which points down. The span is valid until the next tick.
struct Ground {
  static constexpr const char* kType = "ground";
  static constexpr std::size_t kMostSpots = 64;
  static constexpr double kUsualRange = 0.05;  ///< maximum distance of the ground along the line of sight [m]

  Span<const GroundSpot> sensors;

  /// The response of all ground sensors of the suite. @param color of the floor at the spot
  static constexpr float reflection(Color color) { return static_cast<float>(color.brightness()); }
};

template <class Visitor>
void fields(Visitor& visit, Ground& ground) {
  visit(ground.sensors, {"sensors"});
}
REGISTER_DEVICE_OF_SUITE(Ground, kSensor, "Infrared spots that read the floor under the robot, as many as it has.")

}  // namespace swarmanoid
