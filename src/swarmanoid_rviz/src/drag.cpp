#include "drag.hpp"

#include <cmath>

#include "heading.hpp"

namespace swarmanoid {
namespace {

constexpr double kNoMove = 0.01;  // [m]

/// Turns about the vertical of the world, before whatever the orientation is.
geometry_msgs::Quaternion turned(const geometry_msgs::Quaternion& q, double angle) {
  const double s = std::sin(0.5 * angle);
  const double c = std::cos(0.5 * angle);
  geometry_msgs::Quaternion result;
  result.w = c * q.w - s * q.z;
  result.x = c * q.x - s * q.y;
  result.y = c * q.y + s * q.x;
  result.z = c * q.z + s * q.w;
  return result;
}

}  // namespace

void Drag::moveTo(double x, double y) {
  pose_ = start_;
  pose_.position.x += x - grip_x_;
  pose_.position.y += y - grip_y_;
}

void Drag::turnTo(double x, double y) {
  pose_ = start_;
  const double to_x = x - start_.position.x;
  const double to_y = y - start_.position.y;
  if (std::hypot(x - grip_x_, y - grip_y_) >= kNoMove && std::hypot(to_x, to_y) >= kNoMove) {
    pose_.orientation = turned(start_.orientation, std::atan2(to_y, to_x) - headingOf(start_.orientation));
  }
}

bool Drag::isMove() const {
  constexpr double kNoTurn = 0.02;  // [rad]
  const auto& a = start_.orientation;
  const auto& b = pose_.orientation;
  const double cosine = std::abs(a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w);
  return std::hypot(pose_.position.x - start_.position.x, pose_.position.y - start_.position.y) >= kNoMove ||
         cosine < std::cos(0.5 * kNoTurn);
}

}  // namespace swarmanoid
