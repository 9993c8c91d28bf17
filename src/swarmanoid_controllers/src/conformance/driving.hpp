/// Stages of checks in which a robot drives: a footbot by its wheels, other robots by any drive they have.
#pragma once

#include <optional>

#include "checks.hpp"

namespace swarmanoid::conformance {

constexpr double kSpeed = 0.1;             ///< [m/s]
constexpr double kTurnRate = 0.5;          ///< [rad/s]
constexpr double kDrivingPatience = 20.0;  ///< for actions of unknown duration [s]

/// Drives for some time. @param took receives the duration [s] @param begin is called first, or null
Stage drive(Bench& bench, double speed, double turn_rate, const std::shared_ptr<double>& took,
            std::function<void()> begin = nullptr);
/// Turns on the spot until an object has that bearing [rad].
Stage turnTo(Bench& bench, Color color, std::function<double()> bearing);

/// A device that moves the robot, by speed and turn rate.
struct Drive {
  std::string device;
  std::string check;                                            ///< check that tests it first, if possible
  bool returns = false;                                         ///< whether that check ends where it began
  std::function<void(double speed, double turn_rate)> command;  ///< [m/s], [rad/s]
};
/// Returns the device that drives the robot over the ground; nothing if none is listed.
std::optional<Drive> driveOf(const Bench& bench);
/// Returns the device that turns the robot on the spot, or in the air; nothing if none is listed.
std::optional<Drive> turningDriveOf(const Bench& bench);

}  // namespace swarmanoid::conformance
