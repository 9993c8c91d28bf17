/// The force between neighbours of a swarm, after that between molecules.
#pragma once

#include <algorithm>

namespace swarmanoid {

/// A generalised Lennard-Jones force, of the exponents 4 and 2: the derivative of the potential s^4 / 4 - s^2 / 2 by
/// the range, with s = distance / range, times a factor.
/// @param range of the neighbour [m]; below a hundredth of the distance, as noise may have it, it counts as that
/// @param distance at which the force is 0 [m]
/// @return positive: attraction, 1 where it is strongest, which is at 1.29 times the distance; negative: repulsion
inline double lennardJones(double range, double distance) {
  constexpr double kStrongest = 0.1859;  // of s^3 (1 - s^2), where s^2 = 3 / 5
  constexpr double kNearest = 0.01;
  const double s = distance / std::max(range, kNearest * distance);
  return s * s * s * (1.0 - s * s) / kStrongest;
}

}  // namespace swarmanoid
