/// The list of all checks, and functions that several checks use.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench.hpp"
#include "check.hpp"

namespace swarmanoid::conformance {

/// Returns the checks for a robot of this type in this role, in the order in which they are done.
std::vector<Check> checksFor(Bench& bench);

std::vector<Check> footbotChecks(Bench& bench);
std::vector<Check> eyebotChecks(Bench& bench);
std::vector<Check> handbotChecks(Bench& bench);
std::vector<Check> observerChecks(Bench& bench);

// Functions and constants that several checks use.

constexpr double kLeastWay = 0.03;       ///< allowed error of a driven distance [m]
constexpr double kLeastFlownWay = 0.05;  ///< allowed error of a flown distance [m]
constexpr double kLeastAngle = 0.1;      ///< allowed error of a turn [rad]

/// The position of an object before a motion, in the robot's frame [m].
using Place = std::shared_ptr<Eigen::Vector2d>;
inline Place place() { return std::make_shared<Eigen::Vector2d>(Eigen::Vector2d::Zero()); }

/// Checks that beacon and prey are where the surroundings parameters place them.
Check camera(Bench& bench, const std::string& device);
/// Shows LED 0 in red, the LED at a quarter of the ring (to the left) in blue, that at half of it (behind) in green;
/// for an observer.
Check ledsShown(Bench& bench, const std::string& device, std::function<void()> light);
/// Stands still until the effect of a motion can be measured, then judges.
Stage settle(Bench& bench, std::function<void()> judge);
/// Returns "" or the reason why a check that needs the beacon cannot be done.
std::string needsBeacon(const Bench& bench);
std::string needsPrey(const Bench& bench);

}  // namespace swarmanoid::conformance
