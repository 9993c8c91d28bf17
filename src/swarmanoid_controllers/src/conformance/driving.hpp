/// Stages of checks in which a footbot drives.
#pragma once

#include "checks.hpp"

namespace swarmanoid::conformance {

constexpr double kSpeed = 0.1;             ///< [m/s]
constexpr double kTurnRate = 0.5;          ///< [rad/s]
constexpr double kDrivingPatience = 20.0;  ///< for actions of unknown duration [s]

/// Drives for some time. @param took gets the duration [s] @param begin is called before, or null
Stage drive(Bench& bench, double speed, double turn_rate, const std::shared_ptr<double>& took,
            std::function<void()> begin = nullptr);
/// Turns on the spot until an object has that bearing [rad].
Stage turnTo(Bench& bench, Color color, std::function<double()> bearing);

}  // namespace swarmanoid::conformance
