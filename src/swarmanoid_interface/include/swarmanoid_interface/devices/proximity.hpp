/// Sensor: the infrared proximity sensors of any robot, in any number and directions.
#pragma once

#include <cmath>

#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/span.hpp"

namespace swarmanoid {

/// The reading of one sensor.
struct ProximityReading {
  float value = 0.0F;  ///< 0 with nothing in range, rising to 1 at contact
  float angle = 0.0F;  ///< direction of the sensor in the robot's frame [rad], counter-clockwise from ahead, (-pi, pi]
};

template <class Visitor>
void fields(Visitor& visit, ProximityReading& reading) {
  visit(reading.value, {"value", "", "0 without an object in range, 1 at contact", {0.0, 1.0}});
  visit(reading.angle, {"angle", "rad", "direction of the sensor in the robot's frame", {-M_PI, M_PI}, true});
}

/// Readings in the order of the sensors: that of the links proximity_0, proximity_1, ... of the robot's description.
/// The span is valid until the next tick.
struct Proximity {
  static constexpr const char* kType = "proximity";
  static constexpr std::size_t kMostSensors = 64;
  static constexpr double kUsualRange = 0.1;  ///< distance from a sensor at which its response is 0 [m]

  Span<const ProximityReading> sensors;

  /// The response of all proximity sensors of the suite.
  /// @param fraction distance of the obstacle divided by the range: 0 at contact, 1 at the range or beyond
  static constexpr float response(double fraction) {
    const double closeness = 1.0 - fraction;
    return static_cast<float>(closeness * closeness * closeness);
  }
};

template <class Visitor>
void fields(Visitor& visit, Proximity& proximity) {
  visit(proximity.sensors, {"sensors"});
}
REGISTER_DEVICE_OF_SUITE(Proximity, kSensor, "Infrared sensors around the body, as many as the robot has.")

}  // namespace swarmanoid
