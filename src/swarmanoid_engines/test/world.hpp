/// A small world of the kinematic engine.
#pragma once

#include "kinematics2d/kinematics2d.hpp"
#include "planar_world.hpp"

namespace swarmanoid::kinematics2d {
using World = PlanarWorld<Kinematics2d>;
}  // namespace swarmanoid::kinematics2d
