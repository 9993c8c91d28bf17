/// Sensor: the inertial measurement unit of any robot, gyroscopes and accelerometers at its origin.
#pragma once

#include <Eigen/Geometry>

#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid {

/// Readings in the robot's own frame (x ahead, y left, z up), by REP-145.
struct Imu {
  static constexpr const char* kType = "imu";
  static constexpr double kGravity = 9.81;  ///< acceleration of gravity on the Earth [m/s2]

  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  ///< right-handed about x, y, z [rad/s]
  /// Proper acceleration: for a robot at rest gravity, but upwards; in free fall 0 [m/s2].
  Eigen::Vector3d linear_acceleration{0.0, 0.0, kGravity};

  /// Motion and attitude of a robot at a moment, in its own frame.
  struct Motion {
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();          ///< of its origin [m/s]
    Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  ///< [rad/s]
    Eigen::Vector3d up = Eigen::Vector3d::UnitZ();               ///< the upward direction, of length 1
    double gravity = kGravity;                                   ///< downwards, from this moment on [m/s2]
  };

  /// The response of all units of the suite. The acceleration is the mean between two moments: the rate of change of
  /// the velocity in the robot's frame, plus angular velocity x velocity for the rotating frame, plus gravity upwards.
  /// The last two terms use the means of both moments. An arc at constant speed has exactly speed * turn rate.
  /// @param before the motion `dt` earlier; the same as `now` if none is known @param dt greater than 0 [s]
  static Imu reading(const Motion& before, const Motion& now, double dt) {
    const Eigen::Vector3d velocity = 0.5 * (before.velocity + now.velocity);
    const Eigen::Vector3d turning = 0.5 * (before.angular_velocity + now.angular_velocity);
    const Eigen::Vector3d up = 0.5 * (before.up + now.up);
    Imu imu;
    imu.angular_velocity = now.angular_velocity;
    imu.linear_acceleration = (now.velocity - before.velocity) / dt + turning.cross(velocity) + before.gravity * up;
    return imu;
  }
};

template <class Visitor>
void fields(Visitor& visit, Imu& imu) {
  visit(imu.angular_velocity, {"angular_velocity", "rad/s", "right-handed about the robot's axes"});
  visit(imu.linear_acceleration,
        {"linear_acceleration", "m/s2", "as accelerometers measure it: gravity, but upwards, at rest"});
}
REGISTER_DEVICE_OF_SUITE(Imu, kSensor, "Gyroscopes and accelerometers.")

}  // namespace swarmanoid
