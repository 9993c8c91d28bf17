/// The two treels of a robot, and their impulses on the ground, which bring the robot to the commanded motion, as far
/// as the ground holds; the impulse of a slipping treel opposes its slip (Coulomb).
///
/// Frame: the body's centre of mass, at heading 0. SI units. Threads: may run concurrently.
#pragma once

#include <Eigen/Core>
#include <array>

#include "dynamics2d/support.hpp"

namespace swarmanoid::dynamics2d {

struct Treels {
  Eigen::Vector2d left = Eigen::Vector2d::Zero();   ///< its position [m]
  Eigen::Vector2d right = Eigen::Vector2d::Zero();  ///< [m]
  Eigen::Vector2d ahead = Eigen::Vector2d::Zero();  ///< direction of their push
  double track = 0.0;                               ///< cross product of the axle, from right to left, and `ahead` [m]
};

/// Impulses of the left and the right treel [N s].
using TreelImpulses = std::array<Eigen::Vector2d, 2>;

/// @param excess velocity of the centre of mass and turn rate, minus the commanded ones, before any of the impulses
/// @param most limit of a treel's impulse @param guess of the result
/// @param most_sweeps limit of sweeps where treels slip; a caller that iterates needs only one
TreelImpulses treelImpulses(const Treels& treels, double mass, double inertia, const PlanarTwist& excess, double most,
                            const TreelImpulses& guess, int most_sweeps);

/// One cheap step from `impulses` towards the result of treelImpulses, for callers that iterate.
TreelImpulses improvedTreelImpulses(const Treels& treels, double mass, double inertia, const PlanarTwist& excess,
                                    double most, const TreelImpulses& impulses);

/// Sum of the impulses, and of their torques about the centre of mass.
Eigen::Vector3d sumOf(const Treels& treels, const TreelImpulses& impulses);

}  // namespace swarmanoid::dynamics2d
