/// Movements of footbots around objects that they grip.
#pragma once

#include <cmath>

#include "blob_search.hpp"
#include "differential_drive.hpp"

namespace swarmanoid {

/// Turns towards an object, then drives up to it with the gripper ahead.
/// @param prey position of the object @param reach from the robot's axis to the axis of a gripped object, plus a margin
/// [m]
/// @param speed of the robot, @param approach_speed of the final approach [m/s]
inline void driveToGrip(FootbotWheels& wheels, const Sighting& prey, double reach, double speed,
                        double approach_speed) {
  constexpr double kAligned = 0.12;  // rad
  const double bearing = prey.bearing();
  if (std::abs(bearing) > kAligned) {
    // close to the prey the gripper would hit it while turning, so the footbot backs off first
    wheels.drive(prey.distance() < reach ? -0.5 * speed : 0.0, 2.0 * bearing);
  } else {
    wheels.drive(approach_speed, 2.0 * bearing);
  }
}

}  // namespace swarmanoid
