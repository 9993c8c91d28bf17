/// Orientations by three angles, as experiment files and devices give them.
#pragma once

#include <Eigen/Geometry>

namespace swarmanoid {

/// From Euler angles: turns about the fixed x, then y, then z axis (REP-103: roll, pitch, yaw). @param angles [rad]
Eigen::Quaterniond orientationFromAngles(const Eigen::Vector3d& angles);

/// The inverse: about x and z from -pi to pi, about y from -pi/2 to pi/2 [rad]; at the ends of that the first is 0.
Eigen::Vector3d anglesFromOrientation(const Eigen::Quaterniond& orientation);

}  // namespace swarmanoid
