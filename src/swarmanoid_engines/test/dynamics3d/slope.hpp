/// A block on a slope of any kind, which slides from the friction angle on.
#pragma once

#include <gtest/gtest.h>

#include "world.hpp"

namespace swarmanoid::dynamics3d {

struct Slope {
  explicit Slope(World::Values values) : world(std::move(values)) {}
  /// Puts the block onto the slope, with the slope's tilt. @param across horizontal unit vector in the direction of
  /// descent
  void putBlock(const Eigen::Vector3d& on_slope, const Eigen::Quaterniond& tilt, const Eigen::Vector3d& across) {
    down = tilt * across;
    block = world.addBlock({0.2, 0.2, 0.1}, 1.0, {on_slope + tilt * Eigen::Vector3d(0.0, 0.0, 0.05), tilt});
    start = world.pose(block).position;
  }
  Eigen::Vector3d way() const { return world.pose(block).position - start; }

  World world;
  Eigen::Vector3d down;
  Eigen::Vector3d start;
  Row block = kNoRow;
};

/// Expects that the block stays at 0.97 of the friction angle, and slides at 1.03 of it by the laws of Newton and
/// Coulomb.
/// @param direction [rad]; @param most_creep in 5 s of staying [m]; @param most_sideways part of the way that it slides
template <class Made>
void expectToSlideFromTheFrictionAngleOn(double direction, double most_creep, double most_sideways) {
  const double friction_angle = std::atan(0.5);
  for (const char* subclock : {"10", "50"}) {
    Made below(0.97 * friction_angle, direction, {{"friction", "0.5"}, {"subclock", subclock}});
    below.world.step(50);
    EXPECT_LT(below.way().norm(), most_creep);
    Made above(1.03 * friction_angle, direction, {{"friction", "0.5"}, {"subclock", subclock}});
    above.world.step(10);
    const double angle = 1.03 * friction_angle;
    const double expected = 0.5 * kGravity * (std::sin(angle) - 0.5 * std::cos(angle));
    EXPECT_NEAR(above.way().dot(above.down), expected, 0.06 * expected);
    EXPECT_LT((above.way() - above.way().dot(above.down) * above.down).norm(), most_sideways * expected);
  }
}

}  // namespace swarmanoid::dynamics3d
