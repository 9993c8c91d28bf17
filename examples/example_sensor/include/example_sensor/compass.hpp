/// Sensor: a compass. North is the y axis of the arena.
#pragma once

/// What controllers read. The simulated sensor and controllers know each other by kType alone.
struct Compass {
  static constexpr const char* kType = "compass";

  double north = 0.0;  ///< direction of north in the robot's frame [rad], counter-clockwise from ahead, in (-pi, pi]
};
