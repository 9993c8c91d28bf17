/// The balls on which a robot with wheels stands: three for each wheel, one under its axle, and one before and one
/// behind it that keep the robot from tipping.
///
/// A ball touches any ground in a point under the wheel's axle, so a robot turns according to its wheels' separation,
/// which it would not on flat wheels. Seen from above, the balls before and behind lie within the shapes of the body,
/// so obstacles meet the body, never a ball. Their distance from the axle is kSupportReach, or that of the middle of a
/// shape further out that stands on the ground (a caster), but no more than the body's shapes cover. Without a shape
/// that covers them, they are under the axle, and the robot may tip.
#pragma once

#include <vector>

#include "swarmanoid_space/models/entity_model.hpp"

namespace swarmanoid::dynamics3d {

/// Distance of the balls before and behind from the axle, in radii of a wheel. A footbot that pushes as hard as it can
/// must not rear, and its balls must lie under its body.
constexpr double kSupportReach = 1.75;

/// Shapes that end lower than this above the ground stand on it [m].
constexpr double kOnGround = 2e-3;

struct Ball {
  CollisionShape shape;     ///< a sphere, in the body frame
  bool is_support = false;  ///< before or behind the wheel
  int side = 0;             ///< 0 left, 1 right
};

/// Balls of the left wheel, then of the right one: under the axle, before, behind. @pre the model has wheels
std::vector<Ball> ballsOf(const EntityModel& model);

}  // namespace swarmanoid::dynamics3d
