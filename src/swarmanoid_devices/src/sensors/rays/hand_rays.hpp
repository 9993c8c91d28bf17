/// Rays of sensors on a handbot's hands, which move with the arms.
#pragma once

#include <cmath>

#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

/// Current pose of such a sensor, in W.
/// @param mount in the robot's model, with all joints at zero
inline Eigen::Isometry3d placeInWorld(const Space& space, Row row, const Mount& mount) {
  const Pose& pose = space.entities.pose[row];
  Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
  place.translate(pose.position).rotate(pose.orientation);
  place = place * displacementOf(*space.entities.model[row], space.joints[row], mount.joint);
  return place.translate(mount.position).rotate(mount.orientation);
}

/// A bundle of rays around a position, without segments.
/// @param radius distance from there to the farthest ends [m]
inline RayBundle bundleAround(Row robot, const Eigen::Isometry3d& place, double radius) {
  RayBundle rays;
  rays.centre = place.translation();
  rays.radius = radius;
  rays.ignored = robot;
  return rays;
}

}  // namespace swarmanoid::devices
