/// A frame in the middle of a test's world, so that nothing is aligned with the axes of W.
#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

class TurnedFrame {
 public:
  /// @param angle about z [rad] @param origin in W [m]
  explicit TurnedFrame(double angle, const Eigen::Vector3d& origin = {5.0, 5.0, 0.0})
      : turn_(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ())), origin_(origin) {}

  /// Pose in W. @param x, y, heading, z in the frame [m, rad]
  Pose at(double x, double y, double heading = 0.0, double z = 0.0) const {
    return {turn_ * Eigen::Vector3d(x, y, z) + origin_,
            turn_ * Eigen::Quaterniond(Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ()))};
  }
  /// Transforms a position from W to the frame.
  Eigen::Vector3d back(const Eigen::Vector3d& position) const { return turn_.conjugate() * (position - origin_); }
  /// Heading in the frame, of bodies that may be tilted [rad].
  double heading(const Pose& pose) const {
    const Eigen::Vector3d ahead = turn_.conjugate() * pose.orientation * Eigen::Vector3d::UnitX();
    return std::atan2(ahead.y(), ahead.x());
  }

 private:
  Eigen::Quaterniond turn_;
  Eigen::Vector3d origin_;
};

}  // namespace swarmanoid
