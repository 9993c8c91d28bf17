/// Sensor: the microphones of any robot, as many as it has. They hear loudspeakers, by the law of Sound.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>

#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/devices/sound.hpp"
#include "swarmanoid_interface/span.hpp"

namespace swarmanoid {

/// The source that is loudest at the centre of a robot's microphones.
struct LoudestSound {
  static constexpr std::size_t kFewestForBearing = 3;  ///< microphones; with fewer, front and back are ambiguous

  float bearing = 0.0F;     ///< direction in the robot's frame [rad], counter-clockwise from ahead, in (-pi, pi]
  float confidence = 0.0F;  ///< its fraction of the total power, background included, 0 to 1; 0: no bearing
  float frequency = 0.0F;   ///< [Hz]; 0: no source in range

  /// The reading for a source. Real arrays measure the direction of a distant source by the arrival times of its plane
  /// wave; here it is exact at any distance.
  /// @param offset from the centre of the microphones to the source, in the robot's frame [m]
  /// @param part fraction of the total power @param hertz frequency of the source @param microphones their number
  static LoudestSound at(const Eigen::Vector3d& offset, double part, double hertz, std::size_t microphones) {
    LoudestSound loudest;
    loudest.frequency = static_cast<float>(hertz);
    if (microphones >= kFewestForBearing) {
      const auto angle = static_cast<float>(std::atan2(offset.y(), offset.x()));
      loudest.bearing = angle <= -static_cast<float>(M_PI) ? static_cast<float>(M_PI) : angle;
      loudest.confidence = static_cast<float>(part);
    }
    return loudest;
  }
};

template <class Visitor>
void fields(Visitor& visit, LoudestSound& loudest) {
  visit(loudest.bearing, {"bearing",
                          "rad",
                          "of the loudest source in the robot's frame, counter-clockwise from ahead",
                          {-M_PI, M_PI},
                          true});
  visit(loudest.confidence, {"confidence", "", "part of the power of all that is heard; 0: no bearing", {0.0, 1.0}});
  visit(loudest.frequency, {"frequency", "Hz", "of the loudest source; 0: no source is heard", {0.0, 20000.0}});
}

/// The reading and the position of one microphone.
struct Microphone {
  float level = 0.0F;  ///< sound pressure level [dB re 20 uPa]; the background level in silence
  float x = 0.0F;      ///< position in the robot's frame, ahead [m]
  float y = 0.0F;      ///< position in the robot's frame, to the left [m]
};

template <class Visitor>
void fields(Visitor& visit, Microphone& microphone) {
  visit(microphone.level, {"level", "dB", "sound pressure level, re 20 uPa"});
  visit(microphone.x, {"x", "m", "where the microphone is in the robot's frame, ahead"});
  visit(microphone.y, {"y", "m", "where the microphone is in the robot's frame, to the left"});
}

/// Readings in the order of the microphones: that of the links microphone_0, microphone_1, ... of the robot's
/// description. They are omnidirectional. The span is valid until the next tick.
struct Microphones {
  static constexpr const char* kType = "microphones";
  static constexpr std::size_t kMost = 64;

  Span<const Microphone> sensors;
  LoudestSound loudest;
};

template <class Visitor>
void fields(Visitor& visit, Microphones& sensor) {
  visit(sensor.sensors, {"sensors"});
  visit(sensor.loudest, {"loudest"});
}
REGISTER_DEVICE_OF_SUITE(Microphones, kSensor, "Microphones, as many as the robot has.")

}  // namespace swarmanoid
