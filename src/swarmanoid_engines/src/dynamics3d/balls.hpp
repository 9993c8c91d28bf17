/// The balls on which a robot with wheels stands: three for each wheel, one under its axle, and one before and one
/// behind it that keep the robot from tipping.
///
/// A ball touches whatever ground in a point under the wheel's axle, so a robot turns as its wheels' separation says,
/// which flat wheels do not. The ones before and behind lie, seen from above, within the shapes of the body: what is
/// ahead of a robot is met by its body, never by a ball. They are as far from the axle as kSupportReach, or as the
/// middle of a shape of the body that stands on the ground further out (a caster), but no further than the body's
/// shapes cover them. Where no shape covers any, they are under the axle, and the robot may tip.
#pragma once

#include <vector>

#include "swarmanoid_space/models/entity_model.hpp"

namespace swarmanoid::dynamics3d {

/// A footbot that pushes as hard as it can must not rear, and yet its balls lie under its body: ahead of the axle and
/// behind, in radii of a wheel.
constexpr double kSupportReach = 1.75;

/// Shapes of a body that come nearer to the ground than this stand on it [m].
constexpr double kOnGround = 2e-3;

struct Ball {
  CollisionShape shape;     ///< a sphere, in the body frame
  bool is_support = false;  ///< before or behind the wheel
  int side = 0;             ///< 0 left, 1 right
};

/// Of the left wheel, then of the right one: under the axle, before, behind. @param model with wheels
std::vector<Ball> ballsOf(const EntityModel& model);

}  // namespace swarmanoid::dynamics3d
