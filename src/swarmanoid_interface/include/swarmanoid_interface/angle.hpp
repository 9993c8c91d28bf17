/// Wraps angles [rad] into one turn. The only rounding is that of the turn, which is twice the double nearest to pi.
#pragma once

#include <cmath>

namespace swarmanoid {

/// Wraps an angle to [-pi, pi]; both bounds are kept. Returns NaN if the angle is not finite.
inline double wrapAngle(double angle) {
  // within one turn std::remainder returns the same bits but is much slower
  return angle > -M_PI && angle <= M_PI ? angle : std::remainder(angle, 2.0 * M_PI);
}

/// Wraps an angle to (-pi, pi]: half a turn is always pi, never -pi. Returns NaN if the angle is not finite.
inline double wrapTurn(double angle) {
  const double wrapped = wrapAngle(angle);
  return wrapped <= -M_PI ? M_PI : wrapped;
}

}  // namespace swarmanoid
