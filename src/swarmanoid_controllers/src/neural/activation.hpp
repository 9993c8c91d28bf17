/// The functions by which neurons answer. They are made of the exponential alone, which has the same bits on every
/// machine (docs/reference/numerics.md); the C library's hyperbolic tangent has other ones in other versions.
#pragma once

#include <cmath>

namespace swarmanoid::neural {

/// 1 / (1 + e^-x), from 0 to 1.
inline double logistic(double x) { return 1.0 / (1.0 + std::exp(-x)); }

/// The hyperbolic tangent, from -1 to 1.
inline double tanh(double x) {
  const double decay = std::exp(-2.0 * std::abs(x));  // at most 1, so that nothing is infinite
  return std::copysign((1.0 - decay) / (1.0 + decay), x);
}

}  // namespace swarmanoid::neural
