/// Actuator: the flight controller of an eyebot, commanded by target positions.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/devices/eyebot_flight_stop.hpp"

namespace swarmanoid {

/// Positions are in the frame that the robot had at its take-off, upright: x ahead, y left, z up from its lower face.
/// The robot's own position in it is integrated from its motion: carrying the robot away does not count, and errors
/// accumulate. The frame is set where the robot is switched on, and again at each take-off after a landing.
struct EyebotPosition {
  static constexpr const char* kType = "eyebot_position";
  static constexpr const char* kRobot = "eyebot";

  static constexpr double kUsualFastest = 1.0;       ///< in any direction [m/s]
  static constexpr double kUsualAcceleration = 1.0;  ///< [m/s2]
  static constexpr double kUsualFastestTurn = 1.0;   ///< either way [rad/s]
  static constexpr double kUsualSinking = 0.3;       ///< descent speed of a landing [m/s]
  static constexpr double kFarthest = 1e6;           ///< largest coordinate, either way [m]

  enum class Mode : std::uint8_t {
    kHover,    ///< brakes, and stays where it stops
    kTakeOff,  ///< goes straight up or down to the height position.z
    kGoTo,     ///< flies to the position while turning to the yaw
    kLand      ///< descends straight down until it is blocked, and stays there
  };

  Mode mode = Mode::kHover;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< [m]
  double yaw = 0.0;                                    ///< counter-clockwise [rad]

  void hover() { mode = Mode::kHover; }
  void takeOff(double height) { *this = {Mode::kTakeOff, {0.0, 0.0, height}, 0.0}; }
  void goTo(const Eigen::Vector3d& place, double heading) { *this = {Mode::kGoTo, place, heading}; }
  void land() { mode = Mode::kLand; }
};

template <class Visitor>
void fields(Visitor& visit, EyebotPosition& command) {
  const Range reach{-EyebotPosition::kFarthest, EyebotPosition::kFarthest};
  visit(command.mode, {"mode", "", "0: hovers; 1: takes off to the height position[2]; 2: goes to position; 3: lands"});
  visit(command.position, {"position", "m", "in the frame of the take-off: ahead, left, up", reach});
  visit(command.yaw, {"yaw", "rad", "in mode 2, counter-clockwise from the heading at the take-off"});
}
/// Commands hovering, then landing, which continues until the robot is down; an eyebot whose sensors report that it
/// hangs by its magnet stays where it is.
inline bool stopSafely(EyebotPosition& command, const SafeStopMoment& moment) {
  const FlightStop stop = flightStop(moment);
  const bool lands = stop == FlightStop::kDescends || stop == FlightStop::kIsOver;
  command.mode = lands ? EyebotPosition::Mode::kLand : EyebotPosition::Mode::kHover;
  return stop == FlightStop::kHangs || stop == FlightStop::kIsOver;
}
REGISTER_DEVICE_OF_SUITE(EyebotPosition, kActuator, "The flight controller: flies to a place, takes off, lands.")

}  // namespace swarmanoid
