/// Sensor: a compass. North is the y axis of the arena.
#pragma once

#include <cmath>

#include "swarmanoid_interface/device_type.hpp"

/// Reading for controllers. kType alone links the simulated sensor and controllers.
struct Compass {
  static constexpr const char* kType = "compass";

  double north = 0.0;  ///< direction of north in the robot's frame [rad], counter-clockwise from ahead, in (-pi, pi]
};

/// Descriptor of the fields, for recordings, hosts in other processes, and `swarmanoid list`.
template <class Visitor>
void fields(Visitor& visit, Compass& compass) {
  visit(compass.north, {"north", "rad", "direction of north in the robot's frame", {-M_PI, M_PI}});
}
REGISTER_DEVICE(Compass, kSensor, "A compass.")
