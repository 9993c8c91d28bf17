/// Angles [rad] within one turn. Nothing is rounded but the turn itself, which is twice the double nearest to pi.
#pragma once

#include <cmath>

namespace swarmanoid {

/// The same angle in [-pi, pi]; either end stays as it is. NaN for what is not finite.
inline double wrapAngle(double angle) {
  // inside a turn the remainder is the angle itself, to the bit, and takes much longer
  return angle > -M_PI && angle <= M_PI ? angle : std::remainder(angle, 2.0 * M_PI);
}

/// The same angle in (-pi, pi]: half a turn is pi, whichever way it was made. NaN for what is not finite.
inline double wrapTurn(double angle) {
  const double wrapped = wrapAngle(angle);
  return wrapped <= -M_PI ? M_PI : wrapped;
}

}  // namespace swarmanoid
