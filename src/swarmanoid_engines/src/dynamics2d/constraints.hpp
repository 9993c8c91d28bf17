/// What holds the bodies of an island back or drives them in a step. Each constraint keeps the impulse that it has
/// given in the step so far, and solves itself against the velocities of its bodies, exactly but for treels in large
/// islands; the island repeats that until nothing changes any more (projected Gauss-Seidel).
///
/// Bodies are places in the island. SI units, axes of the plane; impulses in N s. `start` begins a step, and gives
/// again the impulse of the step before; `solve` returns by how much it has changed the velocity of a body, turns
/// included [m/s].
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "dynamics2d/contact_patch.hpp"
#include "dynamics2d/support.hpp"
#include "dynamics2d/treels.hpp"

namespace swarmanoid::dynamics2d {

/// Changes of turn rates count as those of the velocity at this distance [m].
constexpr double kTurnArm = 0.1;

/// A body while its island is solved.
struct SolverBody {
  planar::PlacedPose pose;                             ///< of the centre of mass; the heading is not wrapped
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< of the centre of mass [m/s]
  double spin = 0.0;                                   ///< [rad/s]
  double inverse_mass = 0.0;                           ///< 0: mirrors and what is fixed [1/kg]
  double inverse_inertia = 0.0;  ///< about the centre of mass; 0 where inverse_mass is 0 [1/(kg m2)]
  double radius = 0.0;           ///< nothing of it is farther from the centre of mass [m]
  double shifted = 0.0;          ///< no point of it has been shifted farther in this step, all ways added up [m]
  int last_change = 0;           ///< sweep of the solver that changed its velocity last

  /// Change of velocities and turn rate for each unit of impulse at the centre of mass, and of torque.
  Eigen::Vector3d inverseInertia() const { return {inverse_mass, inverse_mass, inverse_inertia}; }
  void noteChange(int sweep) { last_change = inverse_mass > 0.0 ? sweep : last_change; }
  Eigen::Vector2d velocityAt(const Eigen::Vector2d& arm) const {
    return velocity + spin * Eigen::Vector2d(-arm.y(), arm.x());
  }
  void push(const Eigen::Vector2d& impulse, const Eigen::Vector2d& arm) {
    velocity += inverse_mass * impulse;
    spin += inverse_inertia * planar::cross(arm, impulse);
  }
  /// Moves the body without regard to velocities. @param impulse, turn_impulse times a second
  void shift(const Eigen::Vector2d& impulse, const Eigen::Vector2d& arm, double turn_impulse = 0.0);
  /// To where its velocity takes it. @param step [s]
  void advance(double step) {
    pose = planar::PlacedPose::at(pose.position + step * velocity, pose.heading + step * spin, pose);
  }
  /// Returns the change of velocity at a point along a direction for a unit of impulse there along it.
  double yieldAlong(const Eigen::Vector2d& arm, const Eigen::Vector2d& direction) const {
    const double turn = planar::cross(arm, direction);
    return inverse_mass + inverse_inertia * turn * turn;
  }
  /// The change of velocity at a point for each unit of impulse there.
  Eigen::Matrix2d yieldAt(const Eigen::Vector2d& arm) const {
    const Eigen::Vector2d across(-arm.y(), arm.x());
    return inverse_mass * Eigen::Matrix2d::Identity() + inverse_inertia * across * across.transpose();
  }
};

using SolverBodies = std::vector<SolverBody>;

/// Flight: a force and a torque, each limited, towards a commanded motion.
struct FlightConstraint {
  int body = 0;
  Eigen::Vector2d command = Eigen::Vector2d::Zero();  ///< velocity of the centre of mass, at heading 0 [m/s]
  double spin = 0.0;                                  ///< commanded [rad/s]
  double most = 0.0;                                  ///< impulse
  double most_turn = 0.0;                             ///< impulse of torque [N m s]
  Eigen::Vector2d impulse = Eigen::Vector2d::Zero();
  double turn_impulse = 0.0;

  void start(SolverBodies& bodies);
  double solve(SolverBodies& bodies);

 private:
  Eigen::Vector2d velocity_ = Eigen::Vector2d::Zero();
};

/// Treels that drive a robot (treels.hpp).
struct TreelConstraint {
  int body = 0;
  const Treels* treels = nullptr;
  PlanarTwist command = PlanarTwist::Zero();                                 ///< at which nothing slips, at heading 0
  double most = 0.0;                                                         ///< impulse of a treel
  TreelImpulses impulses{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};  ///< at heading 0
  bool is_exact = true;  ///< whether `solve` is exact, or nearer to it by a step that takes a fraction of the time

  void start(SolverBodies& bodies) const;
  double solve(SolverBodies& bodies);
};

/// Friction of a body with the ground on which it slides, on its support (support.hpp).
struct SupportConstraint {
  int body = 0;
  const Support* support = nullptr;
  double most = 0.0;                                  ///< impulse of friction
  Eigen::Vector3d impulse = Eigen::Vector3d::Zero();  ///< with that of torque [N m s], at heading 0
  PlanarTwist last = PlanarTwist::Zero();             ///< velocity after the last solve of this step

  void start(SolverBodies& bodies);
  double solve(SolverBodies& bodies);
};

/// A gripper and what it holds: rigid, or with a turret between, whose motor is solved together with the pivot.
struct GripConstraint {
  enum class Kind { kRigid, kMotor, kPassive };

  int gripper = 0;
  int held = 0;
  Kind kind = Kind::kRigid;
  Eigen::Vector2d on_gripper = Eigen::Vector2d::Zero();  ///< the pivot in the gripper's frame [m]
  Eigen::Vector2d on_held = Eigen::Vector2d::Zero();     ///< and in that of the held body
  double angle = 0.0;                                    ///< heading of the held body minus the gripper's, if rigid
  double speed = 0.0;                                    ///< of the motor [rad/s]
  double most_turn = 0.0;                                ///< impulse of its torque [N m s]
  Eigen::Vector2d impulse = Eigen::Vector2d::Zero();     ///< on the held body
  double turn_impulse = 0.0;                             ///< on the held body

  void start(SolverBodies& bodies);
  double solve(SolverBodies& bodies);
  /// Puts the pivots together again. @return how far they were apart [m]
  double correct(SolverBodies& bodies) const;

 private:
  void give(SolverBodies& bodies, const Eigen::Vector2d& pull, double turn) const;

  Eigen::Vector2d arm_gripper_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d arm_held_ = Eigen::Vector2d::Zero();
  Eigen::Matrix3d yield_ = Eigen::Matrix3d::Zero();  // of pivot and turn
  Eigen::Matrix3d inverse_ = Eigen::Matrix3d::Zero();
  Eigen::Matrix2d pivot_inverse_ = Eigen::Matrix2d::Zero();
};

/// Two shapes that touch, or may within the step: they do not come into each other, and rub (Coulomb). What they still
/// may approach by is the gap between them.
struct ContactConstraint {
  struct Point {
    Eigen::Vector2d arm_a = Eigen::Vector2d::Zero();
    Eigen::Vector2d arm_b = Eigen::Vector2d::Zero();
    double normal_mass = 0.0;    ///< 1 / change of the approach for each unit of impulse [kg]
    double tangent_mass = 0.0;   ///< the same across the normal [kg]
    double approach = 0.0;       ///< most that is allowed [m/s]
    double speed_before = 0.0;   ///< along the normal, at the start of the step [m/s]
    double impulse = 0.0;        ///< along the normal, on b
    double rub = 0.0;            ///< across it, to the left
    double allowed_depth = 0.0;  ///< that may be left after the step [m]
    double clear_until = -1.0;   ///< it is not too deep while the shifts of both bodies are below that in sum [m]
  };

  int a = 0;
  int b = 0;
  int pair = 0;              ///< of bodies, in the island
  std::uint32_t shapes = 0;  ///< which of the pair's: with the points' keys, what is found again in the next step
  ContactPatch patch;
  Eigen::Vector2d normal = Eigen::Vector2d::Zero();  ///< from a to b
  double friction = 0.0;
  double most = 0.0;  ///< impulse along the normal; infinite but for mirrors, which nothing can hold back
  std::array<Point, 2> points;

  /// @param step [s]
  void prepare(const SolverBodies& bodies, double step);
  /// Gives again what was given in the step before.
  void startFrom(const ContactConstraint& before, SolverBodies& bodies);
  double solve(SolverBodies& bodies);
  /// @param restitution part of the speed that comes back; @param slowest that bounces [m/s]
  void bounce(SolverBodies& bodies, double restitution, double slowest);
  /// Pushes bodies out of each other. @return how deep they were, beyond what is allowed [m]
  double correct(SolverBodies& bodies);
  /// Returns how deep a point is, beyond what is allowed [m].
  double depthOf(int point, const Facing& facing) const;

 private:
  std::array<double, 2> normalImpulses(const SolverBody& body_a, const SolverBody& body_b) const;

  double cross_yield_ = 0.0;  // of the approach at one point by an impulse at the other [1/kg]
  double coupling_ = 0.0;     // 1 / determinant of both; 0: nearly the same point
};

}  // namespace swarmanoid::dynamics2d
