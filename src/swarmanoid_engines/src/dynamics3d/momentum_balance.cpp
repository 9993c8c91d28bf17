#include "dynamics3d/momentum_balance.hpp"

#include <algorithm>

namespace swarmanoid::dynamics3d {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

Vector3d BalanceRow::impulseAt(const Vector3d& missing_velocity) const {
  const Vector3d stuck = missing_velocity.cwiseProduct(stiffness);
  const double load = std::max(stuck.x(), 0.0);
  const double most = limit < 0.0 ? contact->coefficient * load : limit;
  const double square = stuck.tail<2>().squaredNorm();
  const double share = square > most * most ? most / std::sqrt(square) : 1.0;
  return {load, share * stuck.y(), share * stuck.z()};
}

Matrix3d BalanceRow::slope() const {
  const Vector3d stuck = missing.cwiseProduct(stiffness);
  const bool is_coupled = limit < 0.0;
  const double pressed = stuck.x() > 0.0 ? stiffness.x() : 0.0;
  const double most = is_coupled ? contact->coefficient * std::max(stuck.x(), 0.0) : limit;
  const double size = stuck.tail<2>().norm();
  Matrix3d slope = Matrix3d::Zero();
  slope(0, 0) = pressed;
  if (size <= most) {
    slope.bottomRightCorner<2, 2>() = stiffness.tail<2>().asDiagonal();
    return slope;
  }
  const Vector2d direction = stuck.tail<2>() / size;
  slope.bottomRightCorner<2, 2>() =
      most / size * (Matrix2d::Identity() - direction * direction.transpose()) * stiffness.tail<2>().asDiagonal();
  if (is_coupled) {
    slope.bottomLeftCorner<2, 1>() = contact->coefficient * pressed * direction;
  }
  return slope;
}

}  // namespace swarmanoid::dynamics3d
