#pragma once

#include <geometry_msgs/Quaternion.h>

#include <cmath>

namespace swarmanoid {

/// Where the x axis points to, seen from above: the angle from the world's x axis, from -pi to pi [rad].
inline double headingOf(const geometry_msgs::Quaternion& q) {
  return std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z));
}

}  // namespace swarmanoid
