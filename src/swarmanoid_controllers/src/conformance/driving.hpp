/// Stages of checks in which a robot drives: a footbot by its wheels, any robot by what it has.
#pragma once

#include <optional>

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

/// What a robot moves with, by speed and turn rate.
struct Drive {
  std::string device;
  std::string check;                                            ///< that tries it first, if it can be done
  bool returns = false;                                         ///< whether that ends where it began
  std::function<void(double speed, double turn_rate)> command;  ///< [m/s], [rad/s]
};
/// Returns what it drives with over the ground; nothing if no such device is listed.
std::optional<Drive> driveOf(const Bench& bench);
/// Returns what it turns with on the spot, or in the air; nothing likewise.
std::optional<Drive> turningDriveOf(const Bench& bench);

}  // namespace swarmanoid::conformance
