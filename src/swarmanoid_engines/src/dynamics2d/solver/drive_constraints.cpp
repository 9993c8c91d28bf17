// Constraints of single bodies: drives and friction with the ground.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "dynamics2d/solver/constraints.hpp"

namespace swarmanoid::dynamics2d {
namespace {

/// Velocity and turn rate of a body at heading 0.
PlanarTwist twistOf(const SolverBody& body) {
  const Eigen::Vector2d velocity = body.pose.unrotated(body.velocity);
  return {velocity.x(), velocity.y(), body.spin};
}

/// @param impulse along x and y, and of torque, at heading 0 @return change of the velocity
double give(SolverBody& body, const Eigen::Vector3d& impulse) {
  const Eigen::Vector3d change = impulse.cwiseProduct(body.inverseInertia());
  body.velocity += body.pose.rotated(change.head<2>());
  body.spin += change.z();
  return std::max(change.head<2>().cwiseAbs().maxCoeff(), kTurnArm * std::abs(change.z()));
}

}  // namespace

void FlightConstraint::start(SolverBodies& bodies) {
  SolverBody& robot = bodies[static_cast<std::size_t>(body)];
  velocity_ = robot.pose.rotated(command);
  robot.velocity += robot.inverse_mass * impulse;
  robot.spin += robot.inverse_inertia * turn_impulse;
}

double FlightConstraint::solve(SolverBodies& bodies) {
  SolverBody& robot = bodies[static_cast<std::size_t>(body)];
  Eigen::Vector2d now = impulse + (velocity_ - robot.velocity) / robot.inverse_mass;
  if (now.squaredNorm() > most * most) {
    now *= most / now.norm();
  }
  const double turn = std::clamp(turn_impulse + (spin - robot.spin) / robot.inverse_inertia, -most_turn, most_turn);
  const Eigen::Vector2d change = robot.inverse_mass * (now - impulse);
  robot.velocity += change;
  const double turn_change = robot.inverse_inertia * (turn - turn_impulse);
  robot.spin += turn_change;
  impulse = now;
  turn_impulse = turn;
  return std::max(change.cwiseAbs().maxCoeff(), kTurnArm * std::abs(turn_change));
}

void TreelConstraint::start(SolverBodies& bodies) const {
  give(bodies[static_cast<std::size_t>(body)], sumOf(*treels, impulses));
}

double TreelConstraint::solve(SolverBodies& bodies) {
  SolverBody& robot = bodies[static_cast<std::size_t>(body)];
  const Eigen::Vector3d before = sumOf(*treels, impulses);
  const PlanarTwist excess = twistOf(robot) - before.cwiseProduct(robot.inverseInertia()) - command;
  const double mass = 1.0 / robot.inverse_mass;
  const double inertia = 1.0 / robot.inverse_inertia;
  impulses = is_exact ? treelImpulses(*treels, mass, inertia, excess, most, impulses, 1)
                      : improvedTreelImpulses(*treels, mass, inertia, excess, most, impulses);
  return give(robot, sumOf(*treels, impulses) - before);
}

void SupportConstraint::start(SolverBodies& bodies) {
  last = twistOf(bodies[static_cast<std::size_t>(body)]);
  give(bodies[static_cast<std::size_t>(body)], impulse);
}

double SupportConstraint::solve(SolverBodies& bodies) {
  SolverBody& slider = bodies[static_cast<std::size_t>(body)];
  if (most <= 0.0) {
    return 0.0;
  }
  const Eigen::Vector3d inertia = slider.inverseInertia().cwiseInverse();
  const PlanarTwist now = twistOf(slider);
  const PlanarTwist free = now - impulse.cwiseQuotient(inertia);
  // a resting body stays near its last solution, a sliding one near its current velocity
  const PlanarTwist after = free.isZero(0.0) ? free : velocityAfterFriction(*support, inertia, free, most, {last, now});
  last = after;
  const Eigen::Vector3d before = impulse;
  impulse = inertia.cwiseProduct(after - free);
  return give(slider, impulse - before);
}

}  // namespace swarmanoid::dynamics2d
