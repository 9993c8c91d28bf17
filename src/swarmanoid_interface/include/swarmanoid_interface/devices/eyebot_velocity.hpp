/// Actuator: the flight controller of an eyebot, commanded a velocity.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace swarmanoid {

/// Desired velocity in the eyebot's own frame (x ahead, y left, z up).
struct EyebotVelocity {
  static constexpr const char* kType = "eyebot_velocity";

  Eigen::Vector3d linear = Eigen::Vector3d::Zero();  ///< [m/s]
  double yaw_rate = 0.0;                             ///< [rad/s], counter-clockwise seen from above

  bool isFinite() const { return linear.allFinite() && std::isfinite(yaw_rate); }
};

}  // namespace swarmanoid
