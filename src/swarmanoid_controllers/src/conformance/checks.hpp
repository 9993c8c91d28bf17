/// The checks of a robot, and functions that several checks use.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench.hpp"
#include "check.hpp"
#include "device_checks.hpp"

namespace swarmanoid::conformance {

/// Returns the checks of the robot in its role, in the order of execution: those of the devices that only robots of its
/// type have, and of all other devices in its configuration.
std::vector<Check> checksFor(Bench& bench);

std::vector<Check> observerChecks(Bench& bench);

/// Sorts checks: first the shown ones, whose observer looks from the start, then those at the start pose, and each
/// check after those that it needs or follows. The order is otherwise kept.
/// @throws std::logic_error if checks wait for each other
std::vector<Check> inOrder(std::vector<Check> checks);

// Functions and constants that several checks use.

constexpr double kLeastWay = 0.03;       ///< allowed error of a driven distance [m]
constexpr double kLeastFlownWay = 0.05;  ///< allowed error of a flown distance [m]
constexpr double kLeastAngle = 0.1;      ///< allowed error of a turn [rad]
/// Colour of a ring in one colour: no two channels of it can be confused.
constexpr Color kOneColor = colors::kOrange;

/// The position of an object before a motion, in the robot's frame [m].
using Place = std::shared_ptr<Eigen::Vector2d>;
inline Place place() { return std::make_shared<Eigen::Vector2d>(Eigen::Vector2d::Zero()); }

/// Returns a function that writes the position of the object of that colour to `before`. @param name for the message if
/// it is not in sight
std::function<void()> rememberPlace(Bench& bench, Color color, const std::string& name, const Place& before);

/// Checks that beacon and prey are at the positions in the surroundings parameters.
Check camera(Bench& bench, const std::string& device);
/// Shows a light for a few seconds, for an observer.
Check shown(Bench& bench, const std::string& device, std::function<void()> light);
/// Shows LED 0 in red, the LED at a quarter of the ring (to the left) in blue, the one at half of it (behind) in green.
template <class Leds>
Check ledsShown(Bench& bench) {
  return shown(bench, Leds::kType, [&bench] {
    Leds& leds = *bench.actuator<Leds>();
    leds.setAll(colors::kBlack);
    leds.ring[0] = colors::kRed;
    leds.ring[Leds::kCount / 4] = colors::kBlue;
    leds.ring[Leds::kCount / 2] = colors::kGreen;
  });
}
/// Stands still until the effect of a motion can be measured, then judges.
Stage settle(Bench& bench, std::function<void()> judge);
/// Shows a ring in one colour, for an observer.
template <class Leds>
Check ringShown(Bench& bench, void (*light)(Leds& leds)) {
  return shown(bench, Leds::kType, [&bench, light] { light(*bench.actuator<Leds>()); });
}
/// Each returns "" or the reason why a check that needs the beacon (prey, wall, ...) is impossible.
std::string needsBeacon(const Bench& bench);
std::string needsPrey(const Bench& bench);
std::string needsWall(const Bench& bench);
std::string needsBoard(const Bench& bench);
std::string needsCeiling(const Bench& bench);
std::string needsPartner(const Bench& bench);
std::string needsRoomAbove(const Bench& bench);

}  // namespace swarmanoid::conformance
