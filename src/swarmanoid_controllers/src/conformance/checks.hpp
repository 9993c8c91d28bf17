/// All checks there are.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench.hpp"
#include "check.hpp"

namespace swarmanoid::conformance {

/// The checks for a robot of this type in this role, in the order in which they are done.
std::vector<Check> checksFor(Bench& bench);

std::vector<Check> footbotChecks(Bench& bench);
std::vector<Check> eyebotChecks(Bench& bench);
std::vector<Check> handbotChecks(Bench& bench);
std::vector<Check> observerChecks(Bench& bench);

// Used by several.

constexpr double kLeastWay = 0.03;       ///< of a driven way, allowed to be wrong [m]
constexpr double kLeastFlownWay = 0.05;  ///< of a flown way, likewise [m]
constexpr double kLeastAngle = 0.1;      ///< of a turn, likewise [rad]

/// Where something was before a motion, in the robot's frame [m].
using Place = std::shared_ptr<Eigen::Vector2d>;
inline Place place() { return std::make_shared<Eigen::Vector2d>(Eigen::Vector2d::Zero()); }

/// Beacon and prey are where the surroundings say.
Check camera(Bench& bench, const std::string& device);
/// LED 0 red, a quarter of the ring (to the left) blue, half of it (behind) green; for an observer.
Check ledsShown(Bench& bench, const std::string& device, std::function<void()> light);
/// Stands still until what was done can be seen, then judges.
Stage settle(Bench& bench, std::function<void()> judge);
/// "" or why something that needs it cannot be done.
std::string needsBeacon(const Bench& bench);
std::string needsPrey(const Bench& bench);

}  // namespace swarmanoid::conformance
