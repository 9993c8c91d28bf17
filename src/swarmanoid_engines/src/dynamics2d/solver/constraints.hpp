/// Constraints that hold back or drive the bodies of an island in a step. Each constraint keeps the impulse that it has
/// applied in the step so far, and solves itself against the velocities of its bodies: exactly, except for treels in
/// large islands. The island repeats that until nothing changes any more (projected Gauss-Seidel).
///
/// Bodies are given by their places in the island. SI units, axes of the plane; impulses in N s. `start` begins a step
/// and applies the impulse of the last step again; `solve` returns the change of a body's velocity, turns included
/// [m/s].
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "dynamics2d/solver/contact_patch.hpp"
#include "dynamics2d/support.hpp"
#include "dynamics2d/treels.hpp"

namespace swarmanoid::dynamics2d {

/// Distance at which changes of turn rates count as changes of velocity [m].
constexpr double kTurnArm = 0.1;

/// A body while its island is solved.
struct SolverBody {
  planar::PlacedPose pose;                             ///< of the centre of mass; the heading is not wrapped
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< of the centre of mass [m/s]
  double spin = 0.0;                                   ///< [rad/s]
  double inverse_mass = 0.0;                           ///< 0 for mirrors and fixed bodies [1/kg]
  double inverse_inertia = 0.0;                        ///< about the centre of mass; 0 if inverse_mass is 0 [1/(kg m2)]
  double radius = 0.0;                                 ///< no point is farther from the centre of mass [m]
  double shifted = 0.0;  ///< no point was moved farther by shifts in this step, all ways added up [m]
  int last_change = 0;   ///< sweep of the solver that changed its velocity last

  /// Change of velocity and turn rate per unit of impulse at the centre of mass, and of torque.
  Eigen::Vector3d inverseInertia() const { return {inverse_mass, inverse_mass, inverse_inertia}; }
  void noteChange(int sweep) { last_change = inverse_mass > 0.0 ? sweep : last_change; }
  Eigen::Vector2d velocityAt(const Eigen::Vector2d& arm) const {
    return velocity + spin * Eigen::Vector2d(-arm.y(), arm.x());
  }
  void push(const Eigen::Vector2d& impulse, const Eigen::Vector2d& arm) {
    velocity += inverse_mass * impulse;
    spin += inverse_inertia * planar::cross(arm, impulse);
  }
  /// Moves the body without changing velocities. @param impulse [N s2] @param turn_impulse [N m s2]
  void shift(const Eigen::Vector2d& impulse, const Eigen::Vector2d& arm, double turn_impulse = 0.0);
  /// Moves the body by its velocity. @param step [s]
  void advance(double step) {
    pose = planar::PlacedPose::at(pose.position + step * velocity, pose.heading + step * spin, pose);
  }
  /// Returns the change of velocity at a point along a direction for a unit of impulse there along it.
  double yieldAlong(const Eigen::Vector2d& arm, const Eigen::Vector2d& direction) const {
    const double turn = planar::cross(arm, direction);
    return inverse_mass + inverse_inertia * turn * turn;
  }
  /// Returns the change of velocity at a point per unit of impulse there.
  Eigen::Matrix2d yieldAt(const Eigen::Vector2d& arm) const {
    const Eigen::Vector2d across(-arm.y(), arm.x());
    return inverse_mass * Eigen::Matrix2d::Identity() + inverse_inertia * across * across.transpose();
  }
};

using SolverBodies = std::vector<SolverBody>;

/// Flight: a limited force and a limited torque towards a commanded motion.
struct FlightConstraint {
  int body = 0;
  Eigen::Vector2d command = Eigen::Vector2d::Zero();  ///< velocity of the centre of mass, at heading 0 [m/s]
  double spin = 0.0;                                  ///< commanded [rad/s]
  double most = 0.0;                                  ///< limit of the impulse
  double most_turn = 0.0;                             ///< limit of the impulse of torque [N m s]
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
  PlanarTwist command = PlanarTwist::Zero();                                 ///< velocity without slip, at heading 0
  double most = 0.0;                                                         ///< limit of a treel's impulse
  TreelImpulses impulses{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};  ///< at heading 0
  bool is_exact = true;  ///< whether `solve` is exact; otherwise it makes one cheap step towards the solution

  void start(SolverBodies& bodies) const;
  double solve(SolverBodies& bodies);
};

/// Friction between the ground and a body that slides on its support (support.hpp).
struct SupportConstraint {
  int body = 0;
  const Support* support = nullptr;
  double most = 0.0;                                  ///< limit of the impulse of friction
  Eigen::Vector3d impulse = Eigen::Vector3d::Zero();  ///< along x and y, and of torque [N m s], at heading 0
  PlanarTwist last = PlanarTwist::Zero();             ///< velocity after the last solve of this step

  void start(SolverBodies& bodies);
  double solve(SolverBodies& bodies);
};

/// A gripper and the body it holds: a rigid joint, or a turret, whose motor is solved together with the pivot.
struct GripConstraint {
  enum class Kind { kRigid, kMotor, kPassive };

  int gripper = 0;
  int held = 0;
  Kind kind = Kind::kRigid;
  Eigen::Vector2d on_gripper = Eigen::Vector2d::Zero();  ///< pivot in the gripper's frame [m]
  Eigen::Vector2d on_held = Eigen::Vector2d::Zero();     ///< pivot in the held body's frame [m]
  double angle = 0.0;                                    ///< heading of the held body minus the gripper's, if rigid
  double speed = 0.0;                                    ///< of the motor [rad/s]
  double most_turn = 0.0;                                ///< limit of the impulse of its torque [N m s]
  Eigen::Vector2d impulse = Eigen::Vector2d::Zero();     ///< on the held body
  double turn_impulse = 0.0;                             ///< on the held body

  void start(SolverBodies& bodies);
  double solve(SolverBodies& bodies);
  /// Closes the gap between the pivots, and the wrong turn of a rigid grip. @return the larger of both before, at the
  /// pivot [m]
  double correct(SolverBodies& bodies) const;

 private:
  void give(SolverBodies& bodies, const Eigen::Vector2d& pull, double turn) const;

  Eigen::Vector2d arm_gripper_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d arm_held_ = Eigen::Vector2d::Zero();
  Eigen::Matrix3d yield_ = Eigen::Matrix3d::Zero();  // of pivot and turn
  Eigen::Matrix3d inverse_ = Eigen::Matrix3d::Zero();
  Eigen::Matrix2d pivot_inverse_ = Eigen::Matrix2d::Zero();
};

/// Two shapes that touch, or may within the step: they must not penetrate each other, and rub (Coulomb). They may still
/// approach by the gap between them.
struct ContactConstraint {
  struct Point {
    Eigen::Vector2d arm_a = Eigen::Vector2d::Zero();
    Eigen::Vector2d arm_b = Eigen::Vector2d::Zero();
    double normal_mass = 0.0;    ///< 1 / change of the approach per unit of impulse [kg]
    double tangent_mass = 0.0;   ///< the same across the normal [kg]
    double approach = 0.0;       ///< largest that is allowed [m/s]
    double speed_before = 0.0;   ///< along the normal, at the start of the step [m/s]
    double impulse = 0.0;        ///< along the normal, on b
    double rub = 0.0;            ///< across the normal, to the left
    double allowed_depth = 0.0;  ///< depth that may remain after the step [m]
    double clear_until = -1.0;   ///< not too deep while the summed shifts of both bodies are below that [m]
  };

  int a = 0;
  int b = 0;
  int pair = 0;              ///< index of the pair of bodies in the island
  std::uint32_t shapes = 0;  ///< of the pair; with the points' keys, they identify contacts in the next step
  ContactPatch patch;
  Eigen::Vector2d normal = Eigen::Vector2d::Zero();  ///< from a to b
  double friction = 0.0;
  double most = 0.0;  ///< limit of the normal impulse; infinite except for mirrors, which nothing can hold back
  std::array<Point, 2> points;

  /// @param step [s]
  void prepare(const SolverBodies& bodies, double step);
  /// Applies the impulses of the step before.
  void startFrom(const ContactConstraint& before, SolverBodies& bodies);
  double solve(SolverBodies& bodies);
  /// @param restitution part of the speed that comes back; @param slowest smallest speed that bounces [m/s]
  void bounce(SolverBodies& bodies, double restitution, double slowest);
  /// Pushes penetrating bodies apart. @return largest depth before, beyond the allowed depth [m]
  double correct(SolverBodies& bodies);
  /// Returns the depth of a point beyond the allowed depth [m].
  double depthOf(int point, const Facing& facing) const;

 private:
  std::array<double, 2> normalImpulses(const SolverBody& body_a, const SolverBody& body_b) const;

  double cross_yield_ = 0.0;  // change of the approach at one point per unit of impulse at the other [1/kg]
  double coupling_ = 0.0;     // 1 / determinant of both; 0 if the points nearly coincide
};

}  // namespace swarmanoid::dynamics2d
