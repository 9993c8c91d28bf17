/// The two treels of a robot and what they push on the ground with: the impulses that bring the robot to the commanded
/// motion, as far as the ground holds; a treel that slips is held back against its slip (Coulomb).
///
/// Frame: the body's centre of mass, at heading 0. SI units. Threads: any at once.
#pragma once

#include <Eigen/Core>
#include <array>

#include "dynamics2d/support.hpp"

namespace swarmanoid::dynamics2d {

struct Treels {
  Eigen::Vector2d left = Eigen::Vector2d::Zero();   ///< where it stands [m]
  Eigen::Vector2d right = Eigen::Vector2d::Zero();  ///< [m]
  Eigen::Vector2d ahead = Eigen::Vector2d::Zero();  ///< the way that they push
  double track = 0.0;                               ///< the axle, from right to left, times `ahead` (cross product) [m]
};

/// Of the left treel and the right one [N s].
using TreelImpulses = std::array<Eigen::Vector2d, 2>;

/// @param excess velocity of the centre of mass, and turn rate, beyond what is commanded, before any of the impulses
/// @param most impulse of a treel @param guess of the result
/// @param most_sweeps of a solution in which both slip: who solves again and again needs but one
TreelImpulses treelImpulses(const Treels& treels, double mass, double inertia, const PlanarTwist& excess, double most,
                            const TreelImpulses& guess, int most_sweeps);

/// The same, nearer to the solution than `impulses`, in a fraction of the time: for who solves again and again.
TreelImpulses improvedTreelImpulses(const Treels& treels, double mass, double inertia, const PlanarTwist& excess,
                                    double most, const TreelImpulses& impulses);

/// Their sum, and that of their torques about the centre of mass.
Eigen::Vector3d sumOf(const Treels& treels, const TreelImpulses& impulses);

}  // namespace swarmanoid::dynamics2d
