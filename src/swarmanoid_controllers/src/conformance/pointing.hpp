/// Stages of checks in which an eyebot points with its laser.
#pragma once

#include "checks.hpp"
#include "swarmanoid_interface/devices/eyebot_laser.hpp"

namespace swarmanoid::conformance {

constexpr double kTilt = 0.3;  ///< default tilt of the laser [rad]

/// Points the laser [rad], stands still, then judges.
inline Stage point(Bench& bench, double pan, double tilt, std::function<void()> judge) {
  Stage stage = settle(bench, std::move(judge));
  stage.begin = [&bench, pan, tilt] { *bench.actuator<EyebotLaser>() = {true, pan, tilt}; };
  return stage;
}

}  // namespace swarmanoid::conformance
