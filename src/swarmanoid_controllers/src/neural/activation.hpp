/// Activation functions of neurons. They use only the exponential, which gives the same bits on every machine
/// (docs/reference/numerics.md); the hyperbolic tangent of the C library differs between its versions.
#pragma once

#include <cmath>

namespace swarmanoid::neural {

/// 1 / (1 + e^-x), from 0 to 1.
inline double logistic(double x) { return 1.0 / (1.0 + std::exp(-x)); }

/// The hyperbolic tangent, from -1 to 1.
inline double tanh(double x) {
  const double decay = std::exp(-2.0 * std::abs(x));  // at most 1, so the result is finite
  return std::copysign((1.0 - decay) / (1.0 + decay), x);
}

}  // namespace swarmanoid::neural
