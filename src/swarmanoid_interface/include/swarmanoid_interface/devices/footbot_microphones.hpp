/// Sensor: the four microphones of a footbot (thesis 1, figure 1.1). They hear loudspeakers, by the law of Sound.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "swarmanoid_interface/devices/microphones.hpp"

namespace swarmanoid {

/// Microphone 0 is straight ahead of the robot's axis (on its x axis), the others follow counter-clockwise every 90
/// degrees. They are omnidirectional.
struct FootbotMicrophones {
  static constexpr const char* kType = "footbot_microphones";
  static constexpr const char* kRobot = "footbot";
  static constexpr std::size_t kCount = 4;
  static constexpr double kRingRadius = 0.07;  ///< of the microphones around the robot's axis [m]
  static constexpr double kHeight = 0.146;     ///< above the ground: on the body [m]

  std::array<float, kCount> level{};  ///< sound pressure levels [dB re 20 uPa]; the background level in silence
  LoudestSound loudest;

  /// Position of microphone `i` in the robot's frame [m].
  static Eigen::Vector3d place(std::size_t i) {
    constexpr std::array<double, kCount> kX{1.0, 0.0, -1.0, 0.0};
    constexpr std::array<double, kCount> kY{0.0, 1.0, 0.0, -1.0};
    return {kRingRadius * kX[i], kRingRadius * kY[i], kHeight};
  }
};

template <class Visitor>
void fields(Visitor& visit, FootbotMicrophones& sensor) {
  visit(sensor.level, {"level", "dB", "sound pressure level, re 20 uPa"});
  visit(sensor.loudest, {"loudest"});
}
REGISTER_DEVICE_OF_SUITE(FootbotMicrophones, kSensor, "Four microphones around the body.")

}  // namespace swarmanoid
