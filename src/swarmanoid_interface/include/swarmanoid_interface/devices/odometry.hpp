/// Sensor: the pose of any robot with a differential drive, estimated from its wheels alone.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid {

/// Readings in the robot's frame at its start: x ahead, y left. Slip of the wheels and carrying the robot cause
/// permanent errors.
struct Odometry {
  static constexpr const char* kType = "odometry";
  static constexpr std::size_t kCoordinates = 3;

  double x = 0.0;          ///< [m]
  double y = 0.0;          ///< [m]
  double heading = 0.0;    ///< counter-clockwise, from -pi to pi [rad]
  double speed = 0.0;      ///< ahead, the mean of the last tick [m/s]
  double turn_rate = 0.0;  ///< counter-clockwise, the mean of the last tick [rad/s]
  /// Covariance of x, y and heading, row by row [m2, m rad, rad2].
  std::array<double, kCoordinates * kCoordinates> covariance{};

  /// Distance that a wheel has rolled in a tick.
  struct Way {
    double length = 0.0;    ///< positive ahead [m]
    double variance = 0.0;  ///< [m2]
  };

  /// Integrates one tick; all odometry of the suite follows this law. The robot moves along the arc of two wheels with
  /// constant speeds during the tick. The covariance is propagated to first order: J P J' + G diag(left, right) G',
  /// with the derivatives of the step J by the pose and G by the two ways (Siegwart and Nourbakhsh, Introduction to
  /// Autonomous Mobile Robots, MIT Press 2004, section 5.2.4).
  /// @param separation between the wheels [m] @param dt greater than 0 [s]
  void roll(const Way& left, const Way& right, double separation, double dt) {
    const double way = 0.5 * (left.length + right.length);
    const double half_turn = 0.5 * (right.length - left.length) / separation;
    const double shortening = half_turn == 0.0 ? 1.0 : std::sin(half_turn) / half_turn;
    const double cosine = std::cos(heading + half_turn);
    const double sine = std::sin(heading + half_turn);
    const double dx = shortening * way * cosine;
    const double dy = shortening * way * sine;
    const auto derivatives = [&](double side) -> std::array<double, kCoordinates> {
      const double turn = side / separation;
      return {0.5 * shortening * cosine - 0.5 * turn * dy, 0.5 * shortening * sine + 0.5 * turn * dx, turn};
    };
    moveCovariance(dx, dy);
    addCovariance(derivatives(-1.0), left.variance);
    addCovariance(derivatives(1.0), right.variance);
    x += dx;
    y += dy;
    heading = wrapAngle(heading + 2.0 * half_turn);
    speed = way / dt;
    turn_rate = 2.0 * half_turn / dt;
  }

 private:
  double& entry(std::size_t row, std::size_t column) { return covariance[row * kCoordinates + column]; }

  /// J P J', where J adds -dy times the error of the heading to that of x, and dx times it to that of y.
  void moveCovariance(double dx, double dy) {
    for (std::size_t column = 0; column < kCoordinates; ++column) {
      entry(0, column) -= dy * entry(2, column);
      entry(1, column) += dx * entry(2, column);
    }
    for (std::size_t row = 0; row < kCoordinates; ++row) {
      entry(row, 0) -= dy * entry(row, 2);
      entry(row, 1) += dx * entry(row, 2);
    }
  }
  void addCovariance(const std::array<double, kCoordinates>& direction, double variance) {
    for (std::size_t row = 0; row < kCoordinates; ++row) {
      for (std::size_t column = 0; column < kCoordinates; ++column) {
        entry(row, column) += direction[row] * direction[column] * variance;
      }
    }
  }
};

template <class Visitor>
void fields(Visitor& visit, Odometry& odometry) {
  visit(odometry.x, {"x", "m", "ahead of the start"});
  visit(odometry.y, {"y", "m", "left of the start"});
  visit(odometry.heading, {"heading", "rad", "counter-clockwise from that at the start", {-M_PI, M_PI}, true});
  visit(odometry.speed, {"speed", "m/s", "ahead, mean of the last tick"});
  visit(odometry.turn_rate, {"turn_rate", "rad/s", "counter-clockwise, mean of the last tick"});
  visit(odometry.covariance, {"covariance", "", "of x, y and heading, row by row, in m and rad"});
}
REGISTER_DEVICE_OF_SUITE(Odometry, kSensor, "Position and heading by the turns of the wheels.")

}  // namespace swarmanoid
