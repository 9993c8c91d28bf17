/// Sensors around a robot's axis: the first looks straight ahead (the robot's x axis), the others follow
/// counter-clockwise, evenly spaced.
#pragma once

#include <cstddef>

namespace swarmanoid {

/// Direction of sensor `i` of `count` in the robot's frame [rad], counter-clockwise from ahead, in (-pi, pi].
constexpr double ringAngle(std::size_t i, std::size_t count) {
  const double step = 6.283185307179586 / static_cast<double>(count);
  return i <= count / 2 ? static_cast<double>(i) * step : (static_cast<double>(i) - static_cast<double>(count)) * step;
}

}  // namespace swarmanoid
