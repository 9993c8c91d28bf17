#include "dynamics3d/mechanisms/flight.hpp"

#include <algorithm>
#include <cmath>

#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;

constexpr double kDrag = 0.3;  // N s/m
// Gains along the horizontal, where the body has to tilt first, and along the vertical.
constexpr double kPlaceGain = 2.0;         // 1/s2
constexpr double kPlaceGainUp = 6.0;       // 1/s2
constexpr double kSpeedGain = 3.0;         // 1/s
constexpr double kSpeedGainUp = 6.0;       // 1/s
constexpr double kMostLead = 0.15;         // m: limit of the distance between the position set point and the robot
constexpr double kMostAcceleration = 3.0;  // m/s2, along the horizontal and the vertical: tilts of 17 degrees
constexpr double kMostThrust = 2.0;        // of the weight
constexpr double kTurnGain = 256.0;        // 1/s2
constexpr double kTurnDamping = 32.0;      // 1/s

/// Sets the set points to the robot's current pose.
void hold(Flight& flight, const Vector3d& centre, const Eigen::Quaterniond& orientation) {
  const Vector3d ahead = orientation * Vector3d::UnitX();
  flight.is_holding = true;
  flight.held = centre;
  flight.heading = std::atan2(ahead.y(), ahead.x());
}

/// Moves the set points, clamped to a distance from the robot so that a blocked robot does not wind up.
void advance(Flight& flight, const Vector3d& centre, const Vector3d& way, double turn) {
  flight.heading = wrapAngle(flight.heading + turn);
  flight.held += way;
  const Vector3d lead = flight.held - centre;
  if (lead.norm() > kMostLead) {
    flight.held = centre + kMostLead / lead.norm() * lead;
  }
}

Vector3d limited(Vector3d acceleration) {
  const double across = acceleration.head<2>().norm();
  if (across > kMostAcceleration) {
    acceleration.head<2>() *= kMostAcceleration / across;
  }
  acceleration.z() = std::clamp(acceleration.z(), -kMostAcceleration, kMostAcceleration);
  return acceleration;
}

/// The attitude whose z axis is along `up` and whose x axis points to the heading.
Eigen::Matrix3d attitude(const Vector3d& up, double heading) {
  Eigen::Matrix3d axes;
  axes.col(2) = up.normalized();
  axes.col(1) = axes.col(2).cross(Vector3d(std::cos(heading), std::sin(heading), 0.0)).normalized();
  axes.col(0) = axes.col(1).cross(axes.col(2));
  return axes;
}

}  // namespace

void fly(Body& robot, double gravity, double step) {
  SWARMANOID_EXPECTS(robot.flight_command.is_driven);
  const FlightCommand& command = robot.flight_command;
  const Vector3d centre = toVector(dBodyGetPosition(robot.rigid));
  const Vector3d speed = toVector(dBodyGetLinearVel(robot.rigid));
  const Vector3d turning = toVector(dBodyGetAngularVel(robot.rigid));
  const Eigen::Quaterniond orientation = toQuaternion(dBodyGetQuaternion(robot.rigid));
  const double mass = robot.model->mass;
  if (!robot.flight.is_holding) {
    hold(robot.flight, centre, orientation);
  }
  const Vector3d wanted = Eigen::AngleAxisd(robot.flight.heading, Vector3d::UnitZ()) * command.linear;
  advance(robot.flight, centre, step * wanted, step * command.yaw_rate);

  const Vector3d place_gain(kPlaceGain, kPlaceGain, kPlaceGainUp);
  const Vector3d speed_gain(kSpeedGain, kSpeedGain, kSpeedGainUp);
  const Vector3d acceleration =
      limited(place_gain.cwiseProduct(robot.flight.held - centre) + speed_gain.cwiseProduct(wanted - speed));
  const Vector3d lift = mass * (acceleration + gravity * Vector3d::UnitZ());
  const Eigen::Matrix3d axes = orientation.toRotationMatrix();
  const double thrust = std::clamp(lift.dot(axes.col(2)), 0.0, kMostThrust * mass * gravity);
  const Vector3d force = thrust * axes.col(2) - kDrag * speed;

  const Eigen::Matrix3d difference =
      attitude(lift.z() > 0.0 ? lift : Vector3d::UnitZ(), robot.flight.heading).transpose() * axes;
  const Eigen::Matrix3d skew = 0.5 * (difference - difference.transpose());
  const Vector3d error(skew(2, 1), skew(0, 2), skew(1, 0));
  const Vector3d rate = axes.transpose() * (turning - command.yaw_rate * Vector3d::UnitZ());
  const Vector3d torque = robot.model->inertia * (-kTurnGain * error - kTurnDamping * rate);

  dBodyAddForce(robot.rigid, force.x(), force.y(), force.z());
  dBodyAddRelTorque(robot.rigid, torque.x(), torque.y(), torque.z());
}

}  // namespace swarmanoid::dynamics3d
