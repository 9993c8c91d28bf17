/// Actuator and sensor: range and bearing, an infrared board that exchanges short messages between robots in sight of
/// each other and measures the position of each sender. Any robot may have it.
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "swarmanoid_interface/arctangent.hpp"
#include "swarmanoid_interface/devices/messages.hpp"

namespace swarmanoid {

/// The transmitter sits at the link `range_and_bearing` of the robot's description, or, if it has none, over its origin
/// in the middle of its height.
struct RangeAndBearing : MessageCommand<10> {
  static constexpr const char* kType = "range_and_bearing";
  static constexpr const char* kLink = "range_and_bearing";
};
REGISTER_DEVICE_OF_SUITE(RangeAndBearing, kActuator,
                         "An infrared board that sends short messages to all robots in sight.")

/// One message, with the position of the sender's transmitter relative to the receiver's.
struct RangeAndBearingMessage {
  float range = 0.0F;      ///< distance between the two transmitters [m]
  float bearing = 0.0F;    ///< direction in the robot's frame [rad], counter-clockwise from ahead, in (-pi, pi]
  float elevation = 0.0F;  ///< of the direction above the robot's x-y plane, from -pi/2 to pi/2 [rad]
  RangeAndBearing::Payload payload{};

  /// Measures the position of a sender. The norms are written out, so that compilers vectorise a loop over messages;
  /// Eigen's norms prevent that.
  /// @param offset from the robot's own transmitter to the sender's, in the robot's frame [m]
  void measure(const Eigen::Vector3d& offset) {
    const auto ahead = static_cast<float>(offset.x());
    const auto left = static_cast<float>(offset.y());
    const auto up = static_cast<float>(offset.z());
    const float angle = arctangent(left, ahead);
    range = static_cast<float>(std::sqrt(offset.x() * offset.x() + offset.y() * offset.y() + offset.z() * offset.z()));
    bearing = angle <= -static_cast<float>(M_PI) ? static_cast<float>(M_PI) : angle;
    elevation = arctangent(up, std::sqrt(ahead * ahead + left * left));
  }
};

template <class Visitor>
void fields(Visitor& visit, RangeAndBearingMessage& message) {
  visit(message.range, {"range", "m", "distance between the two transmitters", {0.0, kInfinity}});
  visit(message.bearing,
        {"bearing", "rad", "direction in the robot's frame, counter-clockwise from ahead", {-M_PI, M_PI}, true});
  visit(message.elevation,
        {"elevation", "rad", "of the direction above the robot's x-y plane", {-M_PI / 2.0, M_PI / 2.0}});
  visit(message.payload, {"payload", "", "the bytes that were sent"});
}

struct RangeAndBearingReceived : ReceivedMessages<RangeAndBearingMessage> {
  static constexpr const char* kType = "range_and_bearing_received";
  static constexpr double kUsualRange = 3.0;  ///< maximum range between transmitters [m]
  static constexpr bool kNeedsSight = true;   ///< obstacles between transmitters block reception
};
REGISTER_DEVICE_OF_SUITE(RangeAndBearingReceived, kSensor,
                         "Messages of the robots in sight, with the distance and direction of each.")

}  // namespace swarmanoid
