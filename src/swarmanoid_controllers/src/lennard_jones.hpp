/// The force between neighbours of a swarm, after that between molecules.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "swarmanoid_interface/devices/range_and_bearing.hpp"

namespace swarmanoid {

/// Generalised Lennard-Jones force with the exponents 4 and 2: the derivative of the potential s^4 / 4 - s^2 / 2 by the
/// range, with s = distance / range, times a factor.
/// @param range of the neighbour [m]; clamped to at least a hundredth of the distance, because noise may make it
/// smaller
/// @param distance at which the force is 0 [m]
/// @return positive: attraction, with the maximum 1 at 1.29 times the distance; negative: repulsion
inline double lennardJones(double range, double distance) {
  constexpr double kStrongest = 0.1859;  // of s^3 (1 - s^2), where s^2 = 3 / 5
  constexpr double kNearest = 0.01;
  const double s = distance / std::max(range, kNearest * distance);
  return s * s * s * (1.0 - s * s) / kStrongest;
}

/// Range of the strongest attraction, as a multiple of the distance at which the force is 0.
constexpr double kStrongestRange = 1.291;

/// Sum of the forces of all neighbours within `reach`, in the robot's x-y plane.
/// @param distance at which a force is 0 [m] @param reach maximum range of the forces [m]
inline Eigen::Vector2d planarForceOfNeighbours(const RangeAndBearingReceived& received, double distance,
                                               double reach = std::numeric_limits<double>::infinity()) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const RangeAndBearingMessage& message : received.messages) {
    const auto range = static_cast<double>(message.range);
    const auto bearing = static_cast<double>(message.bearing);
    if (range <= reach) {
      sum += lennardJones(range, distance) * Eigen::Vector2d(std::cos(bearing), std::sin(bearing));
    }
  }
  return sum;
}

}  // namespace swarmanoid
