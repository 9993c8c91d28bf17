#include "mock_state.hpp"

#include <algorithm>
#include <cmath>

#include "swarmanoid_interface/angle.hpp"

namespace swarmanoid::mock {

void Joint::turn(double way, double fastest, double dt) {
  const double turned = std::clamp(way, -fastest * dt, fastest * dt);
  angle += turned;
  speed = dt > 0.0 ? turned / dt : 0.0;
}

Joint MockState::joint(const std::string& name) const {
  const auto found = joints.find(name);
  return found == joints.end() ? Joint{} : found->second;
}

Holder MockState::holder(const std::string& name) const {
  const auto found = holders.find(name);
  return found == holders.end() ? Holder{} : found->second;
}

void MockState::move(double dt) {
  if (is_fixed) {
    twist = Twist{};
    return;
  }
  // along the chord of the arc
  const double half_turn = 0.5 * twist.yaw_rate * dt;
  const double chord = half_turn == 0.0 ? 1.0 : std::sin(half_turn) / half_turn;
  const double before = pose.position.z();
  Eigen::Vector3d way = twist.linear * dt;
  way.head<2>() *= chord;
  pose.yaw += half_turn;
  pose.position = pose.toWorld(way);
  pose.yaw = wrapAngle(pose.yaw + half_turn);
  pose.position.z() = std::clamp(pose.position.z(), 0.0, std::max(0.0, top));
  twist.linear.z() = dt > 0.0 ? (pose.position.z() - before) / dt : 0.0;
}

}  // namespace swarmanoid::mock
