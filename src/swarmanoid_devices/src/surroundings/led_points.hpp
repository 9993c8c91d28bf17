/// The LEDs of one entity as points in W, by coordinate, so that loops over them can be vectorised.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>

#include "swarmanoid_space/rays/led_shades.hpp"
#include "swarmanoid_space/state/entities.hpp"

namespace swarmanoid::devices {

struct LedPoints {
  using Column = std::array<double, EntityModel::kMaxLeds>;

  std::size_t count = 0;
  Column x;  ///< in W [m]
  Column y;  ///< in W [m]
  Column z;  ///< in W [m]

  LedPoints() = default;
  LedPoints(const EntityModel& model, const Pose& pose)
      : count(std::min(model.led_positions.size(), EntityModel::kMaxLeds)) {
    const Eigen::Matrix3d turn = pose.orientation.toRotationMatrix();
    for (std::size_t k = 0; k < count; ++k) {  // without calls, so that compilers vectorise it
      const Eigen::Vector3d& led = model.led_positions[k];
      x[k] = pose.position.x() + (turn(0, 0) * led.x() + turn(0, 1) * led.y() + turn(0, 2) * led.z());
      y[k] = pose.position.y() + (turn(1, 0) * led.x() + turn(1, 1) * led.y() + turn(1, 2) * led.z());
      z[k] = pose.position.z() + (turn(2, 0) * led.x() + turn(2, 1) * led.y() + turn(2, 2) * led.z());
    }
  }

  Eigen::Vector3d operator[](std::size_t led) const { return {x[led], y[led], z[led]}; }
  /// @pre led <= count; with led == count the count grows
  void set(std::size_t led, const Eigen::Vector3d& point) {
    x[led] = point.x();
    y[led] = point.y();
    z[led] = point.z();
    count = std::max(count, led + 1);
  }
};

}  // namespace swarmanoid::devices
