/// The position controller of an eyebot: computes its velocity from its estimated pose.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/devices/eyebot_position.hpp"

namespace swarmanoid {

/// Frames: O is the frame of the take-off; H is the robot's own frame, upright, with its heading.
/// Phase: `actuate`; `moved` and `fly` alternate, once a tick each. Not thread-safe: one object per robot.
class EyebotPilot {
 public:
  struct Limits {
    double speed = EyebotPosition::kUsualFastest;              ///< [m/s]
    double acceleration = EyebotPosition::kUsualAcceleration;  ///< [m/s2]
    double yaw_rate = EyebotPosition::kUsualFastestTurn;       ///< [rad/s]
    double sinking = EyebotPosition::kUsualSinking;            ///< descent speed of a landing [m/s]
  };
  /// Commanded velocity, in H at the beginning of the tick.
  struct Flight {
    Eigen::Vector3d linear = Eigen::Vector3d::Zero();  ///< [m/s]
    double yaw_rate = 0.0;                             ///< [rad/s]
  };

  /// Adds the motion of the last tick. @param way in H as it is now [m] @param turn [rad] @param dt [s]
  void moved(const Eigen::Vector3d& way, double turn, double dt) {
    yaw_ = wrapAngle(yaw_ + turn);
    position_ += turned(way, yaw_);
    constexpr double kSinks = 0.5;  // fraction of the commanded descent speed
    const bool is_blocked = wanted_sinking_ > 0.0 && -way.z() < kSinks * wanted_sinking_ * dt;
    blocked_ = is_blocked ? blocked_ + dt : 0.0;
    constexpr double kTouchdownTime = 0.5;  // without sinking [s]
    has_landed_ = has_landed_ || blocked_ >= kTouchdownTime;
    is_grounded_ = is_grounded_ || has_landed_;
  }

  /// Returns the velocity for the next tick. @param dt greater than 0 [s]
  Flight fly(const EyebotPosition& command, const Limits& limits, double dt) {
    using Mode = EyebotPosition::Mode;
    if (command.mode != mode_) {
      begin(command.mode, limits);
    }
    Eigen::Vector3d target = held_;
    double yaw = held_yaw_;
    if (mode_ == Mode::kGoTo) {
      target = command.position;
      yaw = command.yaw;
    } else if (mode_ == Mode::kTakeOff) {
      target.z() = command.position.z();
    } else if (mode_ == Mode::kLand) {
      target.z() = position_.z();
    }
    Eigen::Vector3d wanted = approach(target - position_, limits, dt);
    wanted_sinking_ = mode_ == Mode::kLand && !has_landed_ ? limits.sinking : 0.0;
    wanted.z() -= wanted_sinking_;
    const Eigen::Vector3d change = wanted - velocity_;
    velocity_ += change * std::min(1.0, limits.acceleration * dt / std::max(change.norm(), kTiny));
    // while the vertical speed still settles, expect no more descent than velocity_ has
    wanted_sinking_ = std::min(wanted_sinking_, -velocity_.z());
    Flight flight;
    flight.yaw_rate = std::clamp(wrapTurn(yaw - yaw_) / std::max(kResponse, dt), -limits.yaw_rate, limits.yaw_rate);
    flight.linear = turned(velocity_, -yaw_ - 0.5 * flight.yaw_rate * dt);  // along the chord while it turns
    return flight;
  }

  /// Resets to hovering at the estimated position, while another device flies the robot.
  void rest() {
    velocity_.setZero();
    begin(EyebotPosition::Mode::kHover, {});
  }

  const Eigen::Vector3d& position() const { return position_; }  ///< estimated, in O [m]
  double yaw() const { return yaw_; }                            ///< estimated, in O [rad]
  bool hasLanded() const { return has_landed_; }

 private:
  static constexpr double kResponse = 0.5;  // time constant of a short approach [s]
  static constexpr double kTiny = 1e-12;

  static Eigen::Vector3d turned(const Eigen::Vector3d& vector, double angle) {
    const double cosine = std::cos(angle);
    const double sine = std::sin(angle);
    return {cosine * vector.x() - sine * vector.y(), sine * vector.x() + cosine * vector.y(), vector.z()};
  }

  /// Approach velocity from which the robot can brake in time: its norm is proportional to the square root of the
  /// distance, and near the end to the distance.
  static Eigen::Vector3d approach(const Eigen::Vector3d& way, const Limits& limits, double dt) {
    const double response = std::max(kResponse, dt);
    const double length = way.norm();
    const double near = limits.acceleration * response * response;
    const double speed =
        length <= near ? length / response : std::sqrt(2.0 * limits.acceleration * (length - 0.5 * near));
    return way * (std::min(speed, limits.speed) / std::max(length, kTiny));
  }

  void begin(EyebotPosition::Mode mode, const Limits& limits) {
    if (mode == EyebotPosition::Mode::kTakeOff && is_grounded_) {
      velocity_ = turned(velocity_, -yaw_);
      position_.setZero();
      yaw_ = 0.0;
    }
    is_grounded_ = is_grounded_ && (mode == EyebotPosition::Mode::kLand || mode == EyebotPosition::Mode::kHover);
    mode_ = mode;
    has_landed_ = false;
    blocked_ = 0.0;
    const double braking = limits.acceleration > 0.0 ? 0.5 / limits.acceleration : 0.0;
    held_ = position_ + velocity_ * (velocity_.norm() * braking);  // where it comes to rest
    held_yaw_ = yaw_;
  }

  EyebotPosition::Mode mode_ = EyebotPosition::Mode::kHover;
  Eigen::Vector3d position_ = Eigen::Vector3d::Zero();  // in O [m]
  double yaw_ = 0.0;                                    // of H in O [rad]
  Eigen::Vector3d velocity_ = Eigen::Vector3d::Zero();  // commanded, in O [m/s]
  Eigen::Vector3d held_ = Eigen::Vector3d::Zero();      // set point while hovering, in O [m]
  double held_yaw_ = 0.0;                               // [rad]
  double wanted_sinking_ = 0.0;                         // [m/s]
  double blocked_ = 0.0;                                // time without the expected descent [s]
  bool has_landed_ = false;
  bool is_grounded_ = false;  // has landed, and has only been commanded to land or hover since
};

}  // namespace swarmanoid
