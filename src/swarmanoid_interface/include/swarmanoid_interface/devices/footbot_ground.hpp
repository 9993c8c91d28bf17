/// Sensors: the infrared spots under a footbot, which read the reflectance of the floor: 8 around the body, and 4
/// between the wheels. Both respond by the law of Ground::reflection.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>

#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid {

/// Readings of the 8 spots around the body: 0 over black or with no ground in range, 1 over white. Spot 0 is half a
/// step to the left of straight ahead; the others follow counter-clockwise every 45 degrees.
struct FootbotGround {
  static constexpr const char* kType = "footbot_ground";
  static constexpr const char* kRobot = "footbot";
  static constexpr std::size_t kCount = 8;
  static constexpr double kRingRadius = 0.063;  ///< of the spots around the robot's axis [m]

  std::array<float, kCount> value{};

  /// Position of spot `i` in the robot's frame, seen from above [m].
  static Eigen::Vector2d place(std::size_t i) {
    constexpr double kStep = 6.283185307179586 / kCount;
    const double angle = (static_cast<double>(i) + 0.5) * kStep;
    return {kRingRadius * std::cos(angle), kRingRadius * std::sin(angle)};
  }
};

template <class Visitor>
void fields(Visitor& visit, FootbotGround& ground) {
  visit(ground.value, {"value", "", "0 over black or with no ground in range, 1 over white", {0.0, 1.0}});
}
REGISTER_DEVICE_OF_SUITE(FootbotGround, kSensor, "8 infrared spots around the body, which read the floor.")

/// Readings of the 4 spots between the wheels, on the same scale. Spot 0 is ahead on the left, the others follow
/// counter-clockwise.
struct FootbotBaseGround {
  static constexpr const char* kType = "footbot_base_ground";
  static constexpr const char* kRobot = "footbot";
  static constexpr std::size_t kCount = 4;
  static constexpr double kOffset = 0.03;  ///< of each spot from the robot's middle, along x and along y [m]

  std::array<float, kCount> value{};

  /// Position of spot `i` in the robot's frame, seen from above [m].
  static Eigen::Vector2d place(std::size_t i) {
    const bool is_ahead = i == 0 || i == 3;
    const bool is_left = i < 2;
    return {is_ahead ? kOffset : -kOffset, is_left ? kOffset : -kOffset};
  }
};

template <class Visitor>
void fields(Visitor& visit, FootbotBaseGround& ground) {
  visit(ground.value, {"value", "", "0 over black or with no ground in range, 1 over white", {0.0, 1.0}});
}
REGISTER_DEVICE_OF_SUITE(FootbotBaseGround, kSensor, "4 infrared spots between the wheels, which read the floor.")

}  // namespace swarmanoid
