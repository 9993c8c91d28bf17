#include "planar/placed_pose.hpp"

#include <cmath>

#include "swarmanoid_interface/angle.hpp"

namespace swarmanoid::planar {

PlacedPose integrateTurning(const PlacedPose& start, const Eigen::Vector2d& velocity, double turn_rate, double dt) {
  const double turn = turn_rate * dt;
  if (velocity.isZero(0.0)) {
    return PlacedPose::at(start.position, wrapAngle(start.heading + turn));
  }
  // the chord of an arc: as long as the arc times sin(a)/a, turned by a, with a half the turn
  const double half = 0.5 * turn;
  const double cosine = std::cos(half);
  const double sine = std::sin(half);
  const double shortening = std::abs(half) < 1e-4 ? 1.0 - half * half / 6.0 : sine / half;
  const Eigen::Vector2d chord(cosine * velocity.x() - sine * velocity.y(), sine * velocity.x() + cosine * velocity.y());
  return PlacedPose::at(start.position + dt * shortening * start.rotated(chord), wrapAngle(start.heading + turn));
}

Eigen::Vector2d velocityAtEnd(const Eigen::Vector2d& mean, double turn) {
  if (turn == 0.0) {
    return mean;
  }
  // the chord's direction turned by half the turn, times half / sin(half)
  const double half = 0.5 * turn;
  return half / std::tan(half) * mean + half * Eigen::Vector2d(-mean.y(), mean.x());
}

}  // namespace swarmanoid::planar
