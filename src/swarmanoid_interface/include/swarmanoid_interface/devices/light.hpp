/// Sensor: the light sensors of any robot, in any number and directions. They measure the light of LEDs and lamps.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/span.hpp"

namespace swarmanoid {

/// The reading of one sensor.
struct LightReading {
  float value = 0.0F;  ///< 0 in the dark, rising to 1, where it saturates
  float angle = 0.0F;  ///< direction of the sensor in the robot's frame [rad], counter-clockwise from ahead, (-pi, pi]
};

template <class Visitor>
void fields(Visitor& visit, LightReading& reading) {
  visit(reading.value, {"value", "", "0 in the dark, 1 at most", {0.0, 1.0}});
  visit(reading.angle, {"angle", "rad", "direction of the sensor in the robot's frame", {-M_PI, M_PI}, true});
}

/// Readings in the order of the sensors: that of the links light_0, light_1, ... of the robot's description, or, if it
/// has none, of proximity_0, proximity_1, ..., since infrared sensors are sensitive to light as well. The span is valid
/// until the next tick.
struct Light {
  static constexpr const char* kType = "light";
  static constexpr std::size_t kMostSensors = 64;
  static constexpr double kUsualRange = 2.0;         ///< maximum distance of a source [m]
  static constexpr double kReferenceDistance = 0.1;  ///< at which a white LED straight ahead reads 1 [m]

  Span<const LightReading> sensors;

  // The response of all light sensors of the suite: the sum over all visible sources, saturated.

  /// The brightness of a source: 0 for black, 1 for white, 1/3 for a pure red, green or blue.
  static constexpr double brightness(Color color) { return color.brightness(); }
  /// Contribution of one source: brightness * max(0, cos(angle)) * (kReferenceDistance / distance)^2, with the angle
  /// between the direction of the sensor and that of the source.
  /// @param direction in which the sensor looks, of length 1; @param offset from the sensor to the source [m]
  static double share(double brightness, const Eigen::Vector3d& direction, const Eigen::Vector3d& offset) {
    const double ahead = direction.dot(offset);
    return ahead <= 0.0 ? 0.0 : share(brightness, ahead, offset.squaredNorm());
  }
  /// The same for a source in front of the sensor. @param ahead its distance along the direction of the sensor [m],
  /// above 0 @param squared_distance from the sensor [m2]
  static double share(double brightness, double ahead, double squared_distance) {
    const double cosine = ahead / std::sqrt(squared_distance);
    return brightness * cosine * kReferenceDistance * kReferenceDistance / squared_distance;
  }
  /// The reading of a sensor. @param sum of the contributions
  static float response(double sum) { return static_cast<float>(std::min(sum, 1.0)); }
};

template <class Visitor>
void fields(Visitor& visit, Light& light) {
  visit(light.sensors, {"sensors"});
}
REGISTER_DEVICE_OF_SUITE(Light, kSensor, "Light sensors around the body, as many as the robot has.")

}  // namespace swarmanoid
