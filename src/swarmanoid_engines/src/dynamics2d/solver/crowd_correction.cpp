#include "dynamics2d/solver/crowd_correction.hpp"

#include <algorithm>
#include <cmath>

namespace swarmanoid::dynamics2d {
namespace {

/// Displacement of a point after which gaps are computed again [m].
constexpr double kFarthest = 5e-3;
/// A push opens this many times the depth (successive over-relaxation): displacements spread through a crowd of n rows
/// of robots in the order of n sweeps instead of n squared. 2 and more would diverge. Sweeps never undo pushes, so
/// bodies without enough room oscillate; therefore the last sweeps open only the depth itself.
constexpr double kOverRelaxation = 1.9;

}  // namespace

void CrowdCorrection::correct(SolverBodies& bodies, const std::vector<ContactConstraint>& contacts, double allowed) {
  constexpr int kMostRounds = 10;
  constexpr int kMostSweeps = 250;  // in all rounds
  constexpr int kRelaxedSweeps = 150;
  constexpr double kEnough = 0.5;  // of `allowed`: depth that may remain in a linear solution
  int sweeps = 0;
  for (int round = 0; round < kMostRounds && sweeps < kMostSweeps && linearise(bodies, contacts) > allowed; ++round) {
    bool is_done = false;
    for (int i = 1; !is_done && sweeps < kMostSweeps; ++i, ++sweeps) {
      is_done = !sweep(i, kEnough * allowed, sweeps < kRelaxedSweeps ? kOverRelaxation : 1.0) || isFar(bodies);
    }
    apply(bodies);
  }
}

double CrowdCorrection::linearise(const SolverBodies& bodies, const std::vector<ContactConstraint>& contacts) {
  displacements_.clear();
  for (const SolverBody& body : bodies) {
    displacements_.push_back({0.0, 0.0, 0.0, body.inverse_mass, body.inverse_inertia, 0});
  }
  rows_.clear();
  double deepest = 0.0;
  for (const ContactConstraint& contact : contacts) {
    const SolverBody& body_a = bodies[static_cast<std::size_t>(contact.a)];
    const SolverBody& body_b = bodies[static_cast<std::size_t>(contact.b)];
    for (int i = 0; i < contact.patch.count; ++i) {
      const Facing facing = facingAt(contact.patch, i, body_a.pose, body_b.pose);
      const double depth = contact.depthOf(i, facing);
      if (depth < -2.0 * kFarthest) {
        continue;
      }
      deepest = std::max(deepest, depth);
      Row row;
      row.a = static_cast<std::size_t>(contact.a);
      row.b = static_cast<std::size_t>(contact.b);
      row.x = facing.normal.x();
      row.y = facing.normal.y();
      row.lever_a = planar::cross(facing.arm_a, facing.normal);
      row.lever_b = planar::cross(facing.arm_b, facing.normal);
      row.mass =
          1.0 / (body_a.yieldAlong(facing.arm_a, facing.normal) + body_b.yieldAlong(facing.arm_b, facing.normal));
      row.depth = depth;
      rows_.push_back(row);
    }
  }
  return deepest;
}

bool CrowdCorrection::sweep(int number, double allowed, double relaxation) {
  bool has_pushed = false;
  for (const Row& row : rows_) {
    Displacement& a = displacements_[row.a];
    Displacement& b = displacements_[row.b];
    if (number > 1 && std::max(a.last_sweep, b.last_sweep) < number - 1) {
      continue;  // the depth is the same as in the last sweep
    }
    const double opened = row.x * (b.x - a.x) + row.y * (b.y - a.y) + row.lever_b * b.turn - row.lever_a * a.turn;
    const double depth = row.depth - opened;
    if (depth <= allowed) {
      continue;
    }
    has_pushed = true;
    a.last_sweep = number;
    b.last_sweep = number;
    const double impulse = row.mass * std::min(relaxation * depth, kFarthest);
    a.x -= a.inverse_mass * impulse * row.x;
    a.y -= a.inverse_mass * impulse * row.y;
    a.turn -= a.inverse_inertia * impulse * row.lever_a;
    b.x += b.inverse_mass * impulse * row.x;
    b.y += b.inverse_mass * impulse * row.y;
    b.turn += b.inverse_inertia * impulse * row.lever_b;
  }
  return has_pushed;
}

bool CrowdCorrection::isFar(const SolverBodies& bodies) const {
  double farthest = 0.0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Displacement& moved = displacements_[i];
    farthest = std::max(farthest, std::abs(moved.x) + std::abs(moved.y) + bodies[i].radius * std::abs(moved.turn));
  }
  return farthest > kFarthest;
}

void CrowdCorrection::apply(SolverBodies& bodies) const {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Displacement& moved = displacements_[i];
    bodies[i].pose = planar::PlacedPose::nearby(bodies[i].pose, {moved.x, moved.y}, moved.turn);
  }
}

}  // namespace swarmanoid::dynamics2d
