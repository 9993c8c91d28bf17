/// Converts between quaternions and the three angles by which experiment files and devices give orientations.
#pragma once

#include <Eigen/Geometry>

namespace swarmanoid {

/// Converts Euler angles: turns about the fixed x, then y, then z axis (REP-103: roll, pitch, yaw). @param angles [rad]
Eigen::Quaterniond orientationFromAngles(const Eigen::Vector3d& angles);

/// The inverse [rad]: angles about x and z are from -pi to pi, about y from -pi/2 to pi/2. At either end of the range
/// about y, the angle about x is 0.
Eigen::Vector3d anglesFromOrientation(const Eigen::Quaterniond& orientation);

}  // namespace swarmanoid
