/// Actuator: the flight controller of an eyebot, commanded by a velocity.
#pragma once

#include <Eigen/Core>

#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/devices/eyebot_flight_stop.hpp"

namespace swarmanoid {

/// Desired velocity in the eyebot's own frame (x ahead, y left, z up).
struct EyebotVelocity {
  static constexpr const char* kType = "eyebot_velocity";
  static constexpr const char* kRobot = "eyebot";

  static constexpr double kUsualFastest = 1.0;      ///< in any direction [m/s]
  static constexpr double kUsualFastestTurn = 2.0;  ///< either way [rad/s]

  Eigen::Vector3d linear = Eigen::Vector3d::Zero();  ///< [m/s]
  double yaw_rate = 0.0;                             ///< [rad/s], counter-clockwise seen from above
};

template <class Visitor>
void fields(Visitor& visit, EyebotVelocity& velocity) {
  visit(velocity.linear,
        {"linear", "m/s", "velocity in the robot's frame: ahead, left, up; cut to the length max_speed"});
  visit(velocity.yaw_rate, {"yaw_rate", "rad/s", "counter-clockwise seen from above; cut to max_yaw_rate either way"});
}
/// Commands hovering, then a descent; an eyebot whose sensors report that it hangs by its magnet stays where it is.
inline bool stopSafely(EyebotVelocity& velocity, const SafeStopMoment& moment) {
  velocity = EyebotVelocity{};
  const FlightStop stop = flightStop(moment);
  if (stop == FlightStop::kDescends) {
    velocity.linear.z() = -moment.settings.descend_speed;
  }
  return stop == FlightStop::kHangs || stop == FlightStop::kIsOver;
}
REGISTER_DEVICE_OF_SUITE(EyebotVelocity, kActuator, "The flight controller: flies a velocity, hovers at zero.")

}  // namespace swarmanoid
