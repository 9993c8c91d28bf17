/// Limits of flying robots in a plane.
#pragma once

namespace swarmanoid::dynamics2d {

constexpr double kFlightAcceleration = 4.0;       ///< at most [m/s2]
constexpr double kFlightTurnAcceleration = 20.0;  ///< at most [rad/s2]

}  // namespace swarmanoid::dynamics2d
