#include "dynamics2d/treels.hpp"

#include <algorithm>
#include <cmath>

#include "common/coulomb_friction.hpp"
#include "planar/plane.hpp"

namespace swarmanoid::dynamics2d {
namespace {

/// Impulses where a treel slips, solved one after the other until none changes.
/// @param friction returns the impulse of a treel from the yield at its place, its slip with all impulses, and its
/// impulse so far
template <class Friction>
TreelImpulses slippingTreels(const Treels& treels, double mass, double inertia, const PlanarTwist& excess, double most,
                             TreelImpulses impulses, int most_sweeps, Friction friction) {
  constexpr double kSettled = 1e-7;  // of `most`
  const Eigen::Vector3d sum = sumOf(treels, impulses);
  Eigen::Vector2d velocity = excess.head<2>() + sum.head<2>() / mass;
  double turn_rate = excess.z() + sum.z() / inertia;
  const std::array<Eigen::Vector2d, 2> across{Eigen::Vector2d(-treels.left.y(), treels.left.x()),
                                              Eigen::Vector2d(-treels.right.y(), treels.right.x())};
  std::array<Eigen::Matrix2d, 2> yields;
  for (std::size_t i = 0; i < yields.size(); ++i) {
    yields[i] = Eigen::Matrix2d::Identity() / mass + across[i] * across[i].transpose() / inertia;
  }
  double change = 1.0;
  for (int sweep = 0; sweep < most_sweeps && change > kSettled * most; ++sweep) {
    change = 0.0;
    for (std::size_t i = 0; i < impulses.size(); ++i) {
      const Eigen::Vector2d slip = velocity + turn_rate * across[i];
      const Eigen::Vector2d added = friction(yields[i], slip, impulses[i]) - impulses[i];
      impulses[i] += added;
      velocity += added / mass;
      turn_rate += across[i].dot(added) / inertia;
      change = std::max(change, added.norm());
    }
  }
  return impulses;
}

/// Impulses without slip.
TreelImpulses holdingTreels(const Treels& treels, double mass, double inertia, const PlanarTwist& excess) {
  const Eigen::Vector2d half = -0.5 * mass * excess.head<2>();
  const double torque = -inertia * excess.z();
  // each carries half of the force; they push in opposite directions to turn
  const Eigen::Vector2d opposite =
      (torque - planar::cross(treels.left + treels.right, half)) / treels.track * treels.ahead;
  return {half + opposite, half - opposite};
}

bool isHeld(const TreelImpulses& impulses, double most) {
  return std::max(impulses[0].squaredNorm(), impulses[1].squaredNorm()) <= most * most;
}

}  // namespace

Eigen::Vector3d sumOf(const Treels& treels, const TreelImpulses& impulses) {
  const Eigen::Vector2d sum = impulses[0] + impulses[1];
  return {sum.x(), sum.y(), planar::cross(treels.left, impulses[0]) + planar::cross(treels.right, impulses[1])};
}

TreelImpulses treelImpulses(const Treels& treels, double mass, double inertia, const PlanarTwist& excess, double most,
                            const TreelImpulses& guess, int most_sweeps) {
  TreelImpulses holding = holdingTreels(treels, mass, inertia, excess);
  if (isHeld(holding, most)) {
    return holding;
  }
  return slippingTreels(
      treels, mass, inertia, excess, most, guess, most_sweeps,
      [most](const Eigen::Matrix2d& yield, const Eigen::Vector2d& slip, const Eigen::Vector2d& before) {
        return coulombFriction(yield, slip - yield * before, most);
      });
}

TreelImpulses improvedTreelImpulses(const Treels& treels, double mass, double inertia, const PlanarTwist& excess,
                                    double most, const TreelImpulses& impulses) {
  TreelImpulses holding = holdingTreels(treels, mass, inertia, excess);
  if (isHeld(holding, most)) {
    return holding;
  }
  // one step of the projection whose fixed point is Coulomb's law: the impulse that ends the slip, up to the limit
  return slippingTreels(treels, mass, inertia, excess, most, impulses, 1,
                        [=](const Eigen::Matrix2d& yield, const Eigen::Vector2d& slip, const Eigen::Vector2d& before) {
                          const double largest = yield.trace() - 1.0 / mass;  // eigenvalue
                          const Eigen::Vector2d now = before - slip / largest;
                          const double square = now.squaredNorm();
                          return Eigen::Vector2d(square > most * most ? most / std::sqrt(square) * now : now);
                        });
}

}  // namespace swarmanoid::dynamics2d
