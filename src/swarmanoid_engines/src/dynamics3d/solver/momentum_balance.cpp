#include "dynamics3d/solver/momentum_balance.hpp"

#include <algorithm>

#include "common/coulomb_friction.hpp"

namespace swarmanoid::dynamics3d {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

Vector3d BalanceRow::impulseAt(const Vector3d& missing_velocity) const {
  const Vector3d stuck = missing_velocity.cwiseProduct(stiffness);
  const double load = std::max(stuck.x(), 0.0);
  const double most = limit < 0.0 ? contact->coefficient * load : limit;
  const double square = stuck.tail<2>().squaredNorm();
  if (square <= most * most) {
    return {load, stuck.y(), stuck.z()};
  }
  if (most <= 0.0) {
    return {load, 0.0, 0.0};
  }
  if (stiffness.y() == stiffness.z()) {
    const double share = most / std::sqrt(square);
    return {load, share * stuck.y(), share * stuck.z()};
  }
  const Vector2d friction =
      coulombFriction(contact->softness.tail<2>().asDiagonal(), -missing_velocity.tail<2>(), most);
  return {load, friction.x(), friction.y()};
}

Matrix3d BalanceRow::slope() const {
  const Vector3d stuck = missing.cwiseProduct(stiffness);
  const bool is_coupled = limit < 0.0;
  const double pressed = stuck.x() > 0.0 ? stiffness.x() : 0.0;
  const double most = is_coupled ? contact->coefficient * std::max(stuck.x(), 0.0) : limit;
  Matrix3d slope = Matrix3d::Zero();
  slope(0, 0) = pressed;
  if (most <= 0.0) {
    return slope;
  }
  if (stuck.tail<2>().squaredNorm() <= most * most) {
    slope.bottomRightCorner<2, 2>() = stiffness.tail<2>().asDiagonal();
    return slope;
  }
  // friction is the missing velocity over softness plus a resistance, chosen so that friction has the size of the limit
  const Vector2d friction = impulseAt(missing).tail<2>();
  const Vector2d softness = contact->softness.tail<2>();
  const double resistance = (missing.tail<2>() - softness.cwiseProduct(friction)).norm() / most;
  const Vector2d yield = (softness.array() + resistance).inverse();
  const Vector2d softened = yield.cwiseProduct(friction);
  const double size = friction.dot(softened);
  slope.bottomRightCorner<2, 2>() = yield.asDiagonal();
  slope.bottomRightCorner<2, 2>() -= softened * softened.transpose() / size;
  if (is_coupled) {
    slope.bottomLeftCorner<2, 1>() = most / size * contact->coefficient * pressed * softened;
  }
  return slope;
}

}  // namespace swarmanoid::dynamics3d
