#include "dynamics3d/momentum_balance.hpp"

#include <algorithm>

namespace swarmanoid::dynamics3d {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

/// Friction of a contact that slips: along the slip that its softness leaves, as large as the limit.
struct Sliding {
  Vector2d friction;
  Vector2d yield;  ///< inverse of softness and resistance, per axis
};

/// Finds the resistance r >= 0 with |(softness + r)^-1 missing| = limit. @pre the limit is above 0, and friction
/// without resistance is larger
Sliding slide(const Vector2d& softness, const Vector2d& missing, double limit) {
  constexpr int kMostIterations = 30;
  constexpr double kExact = 1e-14;  // of the limit
  // Newton's method on 1 / size, which comes up to the solution from any resistance that is too small
  double resistance = std::max(0.0, missing.norm() / limit - softness.maxCoeff());
  Sliding sliding;
  for (int i = 0; i < kMostIterations; ++i) {
    sliding.yield = (softness.array() + resistance).inverse();
    sliding.friction = sliding.yield.cwiseProduct(missing);
    const double size = sliding.friction.norm();
    if (std::abs(size - limit) <= kExact * limit) {
      break;
    }
    const double slope = sliding.friction.dot(sliding.yield.cwiseProduct(sliding.friction));
    resistance = std::max(0.0, resistance + size * size / slope * (size - limit) / limit);
  }
  return sliding;
}

}  // namespace

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
  const Vector2d friction = slide(contact->softness.tail<2>(), missing_velocity.tail<2>(), most).friction;
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
  const Sliding sliding = slide(contact->softness.tail<2>(), missing.tail<2>(), most);
  const Vector2d softened = sliding.yield.cwiseProduct(sliding.friction);
  const double size = sliding.friction.dot(softened);
  slope.bottomRightCorner<2, 2>() = sliding.yield.asDiagonal();
  slope.bottomRightCorner<2, 2>() -= softened * softened.transpose() / size;
  if (is_coupled) {
    slope.bottomLeftCorner<2, 1>() = most / size * contact->coefficient * pressed * softened;
  }
  return slope;
}

}  // namespace swarmanoid::dynamics3d
