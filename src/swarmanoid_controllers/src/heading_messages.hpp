/// Headings that the robots of a flock broadcast over range and bearing, and the mean of those received.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>

#include "swarmanoid_interface/devices/range_and_bearing.hpp"

namespace swarmanoid {

constexpr double kStepsOfTurn = 65536.0;  // number of angles that two bytes can encode

/// @param heading relative to a reference direction that all robots share [rad]
inline RangeAndBearing::Payload payloadOfHeading(double heading) {
  // an unsigned number of 16 bits wraps around as an angle does
  const auto steps = static_cast<std::uint16_t>(std::llround(heading / (2.0 * M_PI) * kStepsOfTurn));
  RangeAndBearing::Payload payload{};
  payload[0] = static_cast<std::uint8_t>(steps >> 8U);
  payload[1] = static_cast<std::uint8_t>(steps & 0xFFU);
  return payload;
}

/// @return [rad], from 0 to 2 pi
inline double headingIn(const RangeAndBearing::Payload& payload) {
  return (256.0 * payload[0] + payload[1]) / kStepsOfTurn * 2.0 * M_PI;
}

/// @param own_heading relative to the shared reference direction [rad]
/// @return unit vector of the mean heading of all neighbours in the robot's frame; straight ahead without neighbours
inline Eigen::Vector2d alignment(const RangeAndBearingReceived& received, double own_heading) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const RangeAndBearingMessage& message : received.messages) {
    const double relative = headingIn(message.payload) - own_heading;
    sum += Eigen::Vector2d(std::cos(relative), std::sin(relative));
  }
  return sum.isZero() ? Eigen::Vector2d::UnitX().eval() : sum.normalized();
}

}  // namespace swarmanoid
