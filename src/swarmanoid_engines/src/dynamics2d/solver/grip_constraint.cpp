#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "dynamics2d/solver/constraints.hpp"
#include "swarmanoid_interface/angle.hpp"

namespace swarmanoid::dynamics2d {
namespace {

/// Change of the relative velocity of pivot and turn of two bodies, per unit of impulse.
Eigen::Matrix3d yieldOf(const SolverBody& gripper, const Eigen::Vector2d& arm_gripper, const SolverBody& held,
                        const Eigen::Vector2d& arm_held) {
  Eigen::Matrix3d yield;
  yield.topLeftCorner<2, 2>() = gripper.yieldAt(arm_gripper) + held.yieldAt(arm_held);
  const Eigen::Vector2d turn = gripper.inverse_inertia * Eigen::Vector2d(-arm_gripper.y(), arm_gripper.x()) +
                               held.inverse_inertia * Eigen::Vector2d(-arm_held.y(), arm_held.x());
  yield.topRightCorner<2, 1>() = turn;
  yield.bottomLeftCorner<1, 2>() = turn.transpose();
  yield(2, 2) = gripper.inverse_inertia + held.inverse_inertia;
  return yield;
}

}  // namespace

void GripConstraint::start(SolverBodies& bodies) {
  const SolverBody& body_gripper = bodies[static_cast<std::size_t>(gripper)];
  const SolverBody& body_held = bodies[static_cast<std::size_t>(held)];
  arm_gripper_ = body_gripper.pose.rotated(on_gripper);
  arm_held_ = body_held.pose.rotated(on_held);
  yield_ = yieldOf(body_gripper, arm_gripper_, body_held, arm_held_);
  inverse_ = yield_.inverse();
  pivot_inverse_ = yield_.topLeftCorner<2, 2>().inverse();
  give(bodies, impulse, turn_impulse);
}

void GripConstraint::give(SolverBodies& bodies, const Eigen::Vector2d& pull, double turn) const {
  SolverBody& body_gripper = bodies[static_cast<std::size_t>(gripper)];
  SolverBody& body_held = bodies[static_cast<std::size_t>(held)];
  body_gripper.push(-pull, arm_gripper_);
  body_gripper.spin -= body_gripper.inverse_inertia * turn;
  body_held.push(pull, arm_held_);
  body_held.spin += body_held.inverse_inertia * turn;
}

double GripConstraint::solve(SolverBodies& bodies) {
  const SolverBody& body_gripper = bodies[static_cast<std::size_t>(gripper)];
  const SolverBody& body_held = bodies[static_cast<std::size_t>(held)];
  const Eigen::Vector2d apart = body_held.velocityAt(arm_held_) - body_gripper.velocityAt(arm_gripper_);
  double turn = 0.0;
  Eigen::Vector2d pull;
  if (kind == Kind::kPassive) {
    pull = -(pivot_inverse_ * apart);
  } else {
    const double wanted = kind == Kind::kMotor ? speed : 0.0;
    const Eigen::Vector3d wrong(apart.x(), apart.y(), body_held.spin - body_gripper.spin - wanted);
    const Eigen::Vector3d exact = -(inverse_ * wrong);
    turn = exact.z();
    pull = exact.head<2>();
    if (kind == Kind::kMotor && std::abs(turn_impulse + turn) > most_turn) {
      turn = std::clamp(turn_impulse + turn, -most_turn, most_turn) - turn_impulse;
      pull = -(pivot_inverse_ * (apart + turn * yield_.topRightCorner<2, 1>()));
    }
  }
  impulse += pull;
  turn_impulse += turn;
  give(bodies, pull, turn);
  const Eigen::Vector3d change = yield_ * Eigen::Vector3d(pull.x(), pull.y(), turn);
  return std::max(change.head<2>().cwiseAbs().maxCoeff(), kTurnArm * std::abs(change.z()));
}

double GripConstraint::correct(SolverBodies& bodies) const {
  SolverBody& body_gripper = bodies[static_cast<std::size_t>(gripper)];
  SolverBody& body_held = bodies[static_cast<std::size_t>(held)];
  const Eigen::Vector2d arm_gripper = body_gripper.pose.rotated(on_gripper);
  const Eigen::Vector2d arm_held = body_held.pose.rotated(on_held);
  const Eigen::Vector2d apart = body_held.pose.position + arm_held - body_gripper.pose.position - arm_gripper;
  const Eigen::Matrix3d yield = yieldOf(body_gripper, arm_gripper, body_held, arm_held);
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  double wrong_turn = 0.0;
  if (kind == Kind::kRigid) {
    wrong_turn = wrapAngle(body_held.pose.heading - body_gripper.pose.heading - angle);
    shift = -(yield.inverse() * Eigen::Vector3d(apart.x(), apart.y(), wrong_turn));
  } else {
    shift.head<2>() = -(yield.topLeftCorner<2, 2>().inverse() * apart);
  }
  body_gripper.shift(-shift.head<2>(), arm_gripper, -shift.z());
  body_held.shift(shift.head<2>(), arm_held, shift.z());
  return std::max(apart.cwiseAbs().maxCoeff(), std::abs(wrong_turn) * arm_held.norm());
}

}  // namespace swarmanoid::dynamics2d
