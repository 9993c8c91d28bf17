/// A small world of the two-dimensional dynamic engine.
#pragma once

#include "../planar_world.hpp"
#include "dynamics2d/dynamics2d.hpp"

namespace swarmanoid::dynamics2d {

using World = PlanarWorld<Dynamics2d>;

constexpr double kGravity = 9.81;  // m/s2

/// A world with non-default parameters of the engine.
inline World worldWith(const std::map<std::string, std::string>& parameters, int subclock = 10) {
  return World({10.0, 10.0, 2.0}, subclock, "z", 0.0, parameters);
}

}  // namespace swarmanoid::dynamics2d
