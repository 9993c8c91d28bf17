#pragma once

#include <geometry_msgs/Quaternion.h>

#include <Eigen/Geometry>

#include "swarmanoid_interface/orientation.hpp"

namespace swarmanoid {

inline Eigen::Quaterniond toEigen(const geometry_msgs::Quaternion& q) { return {q.w, q.x, q.y, q.z}; }

/// Heading of the body's x axis, seen from above: angle from the world's x axis, from -pi to pi [rad].
inline double headingOf(const geometry_msgs::Quaternion& q) { return anglesFromOrientation(toEigen(q)).z(); }

}  // namespace swarmanoid
