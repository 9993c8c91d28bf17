// Drives and friction with the ground: what holds a body by itself.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "dynamics2d/constraints.hpp"

namespace swarmanoid::dynamics2d {

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

void SupportConstraint::start(SolverBodies& bodies) const {
  SolverBody& slider = bodies[static_cast<std::size_t>(body)];
  slider.velocity += slider.inverse_mass * slider.pose.rotated(impulse.head<2>());
  slider.spin += slider.inverse_inertia * impulse.z();
}

double SupportConstraint::solve(SolverBodies& bodies) {
  SolverBody& slider = bodies[static_cast<std::size_t>(body)];
  if (most <= 0.0) {
    return 0.0;
  }
  const Eigen::Vector3d inertia(1.0 / slider.inverse_mass, 1.0 / slider.inverse_mass, 1.0 / slider.inverse_inertia);
  const Eigen::Vector2d velocity = slider.pose.unrotated(slider.velocity);
  const PlanarTwist before(velocity.x(), velocity.y(), slider.spin);
  const PlanarTwist free = before - impulse.cwiseQuotient(inertia);
  const PlanarTwist slip = free - command;
  const PlanarTwist after =
      slip.isZero(0.0) ? free : command + velocityAfterFriction(*support, inertia, slip, most, before - command);
  impulse = inertia.cwiseProduct(after - free);
  slider.velocity = slider.pose.rotated(after.head<2>());
  slider.spin = after.z();
  const PlanarTwist change = after - before;
  return std::max(change.head<2>().cwiseAbs().maxCoeff(), kTurnArm * std::abs(change.z()));
}

Eigen::Vector2d SupportConstraint::impulseAt(std::size_t point, const SolverBodies& bodies) const {
  const SolverBody& slider = bodies[static_cast<std::size_t>(body)];
  const Eigen::Vector2d velocity = slider.pose.unrotated(slider.velocity);
  const PlanarTwist slip = PlanarTwist(velocity.x(), velocity.y(), slider.spin) - command;
  return slider.pose.rotated(most * frictionAt(support->points[point], slip));
}

}  // namespace swarmanoid::dynamics2d
