/// Planar pose for placing shapes, and its integration at constant velocity.
#pragma once

#include <cmath>

#include "planar/plane.hpp"

namespace swarmanoid::planar {

/// A pose with the cosine and sine of its heading.
struct PlacedPose {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  double heading = 0.0;
  double cosine = 1.0;
  double sine = 0.0;

  static PlacedPose at(const Eigen::Vector2d& position, double heading) {
    return {position, heading, std::cos(heading), std::sin(heading)};
  }
  /// As above, but without computing cosine and sine if the heading equals that of `similar`: most bodies move
  /// straight.
  static PlacedPose at(const Eigen::Vector2d& position, double heading, const PlacedPose& similar) {
    return heading == similar.heading ? PlacedPose{position, heading, similar.cosine, similar.sine}
                                      : at(position, heading);
  }
  /// A known pose, moved and turned a little: as exact as `at`, but much faster.
  /// @param way [m] @param turn [rad]
  static PlacedPose nearby(const PlacedPose& pose, const Eigen::Vector2d& way, double turn) {
    constexpr double kSmall = 1e-3;  // rad: the next term of both series is below the last digit
    if (std::abs(turn) > kSmall) {
      return at(pose.position + way, pose.heading + turn);
    }
    const double square = turn * turn;
    const double sine = turn * (1.0 - square / 6.0 * (1.0 - square / 20.0));
    const double versine = 0.5 * square * (1.0 - square / 12.0 * (1.0 - square / 30.0));
    return {pose.position + way, pose.heading + turn, pose.cosine - versine * pose.cosine - sine * pose.sine,
            pose.sine - versine * pose.sine + sine * pose.cosine};
  }
  Eigen::Vector2d rotated(const Eigen::Vector2d& p) const {
    return {cosine * p.x() - sine * p.y(), sine * p.x() + cosine * p.y()};
  }
  /// The inverse of `rotated`.
  Eigen::Vector2d unrotated(const Eigen::Vector2d& p) const {
    return {cosine * p.x() + sine * p.y(), cosine * p.y() - sine * p.x()};
  }
};

/// Pose of a body after a time with a velocity that is constant in its own, turning frame: exact along the arc.
/// @param velocity [m/s]; @param turn_rate [rad/s]; @param dt [s]
PlacedPose integrateTurning(const PlacedPose& start, const Eigen::Vector2d& velocity, double turn_rate, double dt);
inline PlacedPose integrate(const PlacedPose& start, const Eigen::Vector2d& velocity, double turn_rate, double dt) {
  if (turn_rate * dt != 0.0) {
    return integrateTurning(start, velocity, turn_rate, dt);
  }
  PlacedPose end = start;
  end.position += dt * start.rotated(velocity);
  return end;
}

/// Inverse of `integrate`: the velocity at the end of an arc of constant speed and turn rate.
/// @param mean velocity along the chord [m/s]; @param turn from the start of the arc to its end, in (-pi, pi]
Eigen::Vector2d velocityAtEnd(const Eigen::Vector2d& mean, double turn);

}  // namespace swarmanoid::planar
