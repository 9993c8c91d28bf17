#include "drag.hpp"

#include <cmath>

#include "heading.hpp"

namespace swarmanoid {
namespace {

constexpr double kNoMove = 0.01;  // [m]

/// Rotates an orientation about the world's z axis.
geometry_msgs::Quaternion turned(const geometry_msgs::Quaternion& q, double angle) {
  const Eigen::Quaterniond after = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()) * toEigen(q);
  geometry_msgs::Quaternion result;
  result.w = after.w();
  result.x = after.x();
  result.y = after.y();
  result.z = after.z();
  return result;
}

}  // namespace

geometry_msgs::Pose Drag::applyTo(const geometry_msgs::Pose& now) const {
  geometry_msgs::Pose pose = now;
  if (!turns_) {
    pose.position.x = start_.position.x + x_ - grip_x_;
    pose.position.y = start_.position.y + y_ - grip_y_;
    return pose;
  }
  const double x = x_ - now.position.x;
  const double y = y_ - now.position.y;
  if (std::hypot(x, y) >= kNoMove) {
    pose.orientation = turned(now.orientation, std::atan2(y, x) - headingOf(now.orientation));
  }
  return pose;
}

bool Drag::isMove() const {
  if (std::hypot(x_ - grip_x_, y_ - grip_y_) < kNoMove) {
    return false;
  }
  constexpr double kNoTurn = 0.02;  // [rad]
  const auto& a = start_.orientation;
  const auto b = pose().orientation;
  const double cosine = std::abs(a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w);
  return !turns_ || cosine < std::cos(0.5 * kNoTurn);
}

}  // namespace swarmanoid
