#include "common/coulomb_friction.hpp"

#include <algorithm>
#include <cmath>

namespace swarmanoid {

Eigen::Vector2d coulombFriction(const Eigen::Matrix2d& yield, const Eigen::Vector2d& slip, double most) {
  constexpr int kMostIterations = 30;
  constexpr double kExact = 1e-13;  // of `most`
  if (!(most > 0.0)) {
    return Eigen::Vector2d::Zero();
  }
  // The remaining slip is slip + yield * friction, with friction = -remaining / resistance. The resistance is zero if
  // friction ends the slip. Otherwise it is the resistance at which the friction reaches its limit: Newton's method on
  // 1 / size finds it, and converges from any smaller value.
  double resistance = std::max(0.0, slip.norm() / most - yield.trace());
  Eigen::Vector2d friction = Eigen::Vector2d::Zero();
  double size = most;
  for (int i = 0; i < kMostIterations; ++i) {
    const double a = yield(0, 0) + resistance;
    const double b = yield(0, 1);
    const double d = yield(1, 1) + resistance;
    const double scale = 1.0 / (a * d - b * b);
    friction = -scale * Eigen::Vector2d(d * slip.x() - b * slip.y(), a * slip.y() - b * slip.x());
    size = friction.norm();
    if (size <= most && resistance == 0.0) {
      return friction;
    }
    if (std::abs(size - most) <= kExact * most) {
      break;
    }
    const Eigen::Vector2d softened(d * friction.x() - b * friction.y(), a * friction.y() - b * friction.x());
    const double change = size * size / (scale * friction.dot(softened)) * (size - most) / most;
    resistance = std::max(0.0, resistance + change);
  }
  return friction * (most / size);
}

}  // namespace swarmanoid
