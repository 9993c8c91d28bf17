/// Sensor: the pose of any robot, as measured by an external tracking system.
#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/orientation.hpp"

namespace swarmanoid {

/// Readings in the frame of the world, which all robots share: the position of the robot's origin, and the orientation
/// of its own frame (x ahead, y left, z up) by turns about the world's x, then y, then z axis (REP-103).
struct Positioning {
  static constexpr const char* kType = "positioning";

  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< [m]
  double roll = 0.0;                                   ///< from -pi to pi [rad]
  double pitch = 0.0;    ///< positive: nose down, from -pi/2 to pi/2; at either end the roll is 0 [rad]
  double heading = 0.0;  ///< counter-clockwise from the world's x axis, from -pi to pi [rad]

  /// The reading of a system without errors.
  static Positioning reading(const Eigen::Vector3d& position, const Eigen::Quaterniond& orientation) {
    const Eigen::Vector3d angles = anglesFromOrientation(orientation);
    return {position, angles.x(), angles.y(), angles.z()};
  }
  Eigen::Quaterniond orientation() const { return orientationFromAngles({roll, pitch, heading}); }
};

template <class Visitor>
void fields(Visitor& visit, Positioning& positioning) {
  visit(positioning.position, {"position", "m", "of the robot's origin in the world"});
  visit(positioning.roll, {"roll", "rad", "about the world's x axis, before the other two turns", {-M_PI, M_PI}, true});
  visit(positioning.pitch, {"pitch", "rad", "then about its y axis: nose down", {-M_PI / 2, M_PI / 2}});
  visit(positioning.heading, {"heading", "rad", "then about its z axis: counter-clockwise", {-M_PI, M_PI}, true});
}
REGISTER_DEVICE_OF_SUITE(Positioning, kSensor, "Position and orientation in the world.")

}  // namespace swarmanoid
