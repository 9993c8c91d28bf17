#include "swarmanoid_interface/orientation.hpp"

#include <algorithm>
#include <cmath>

#include "swarmanoid_interface/angle.hpp"

namespace swarmanoid {

Eigen::Quaterniond orientationFromAngles(const Eigen::Vector3d& angles) {
  using Eigen::AngleAxisd;
  using Eigen::Vector3d;
  return AngleAxisd(angles.z(), Vector3d::UnitZ()) * AngleAxisd(angles.y(), Vector3d::UnitY()) *
         AngleAxisd(angles.x(), Vector3d::UnitX());
}

Eigen::Vector3d anglesFromOrientation(const Eigen::Quaterniond& q) {
  const double sine_pitch = std::clamp(2.0 * (q.w() * q.y() - q.z() * q.x()), -1.0, 1.0);
  constexpr double kUpright = 1.0 - 1e-12;
  if (std::abs(sine_pitch) > kUpright) {
    // gimbal lock: the turns about x and z have the same axis, and yaw takes both
    const double half_yaw = std::atan2(std::copysign(1.0, -sine_pitch) * q.x(), q.w());
    return {0.0, std::copysign(M_PI / 2.0, sine_pitch), wrapAngle(2.0 * half_yaw)};
  }
  const double roll = std::atan2(2.0 * (q.w() * q.x() + q.y() * q.z()), 1.0 - 2.0 * (q.x() * q.x() + q.y() * q.y()));
  const double yaw = std::atan2(2.0 * (q.w() * q.z() + q.x() * q.y()), 1.0 - 2.0 * (q.y() * q.y() + q.z() * q.z()));
  return {roll, std::asin(sine_pitch), yaw};
}

}  // namespace swarmanoid
