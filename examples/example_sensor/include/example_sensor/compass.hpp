/// Sensor: a compass. North is the y axis of the arena.
#pragma once

#include <cmath>

#include "swarmanoid_interface/device_type.hpp"

/// What controllers read. The simulated sensor and controllers know each other by kType alone.
struct Compass {
  static constexpr const char* kType = "compass";

  double north = 0.0;  ///< direction of north in the robot's frame [rad], counter-clockwise from ahead, in (-pi, pi]
};

/// Its descriptor: what others than controllers go by, such as recordings, hosts in other processes, `swarmanoid list`.
template <class Visitor>
void fields(Visitor& visit, Compass& compass) {
  visit(compass.north, {"north", "rad", "direction of north in the robot's frame", {-M_PI, M_PI}});
}
REGISTER_DEVICE(Compass, kSensor, "A compass.")
