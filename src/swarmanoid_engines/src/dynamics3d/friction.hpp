/// Coulomb's friction, as ODE can have it.
///
/// ODE limits friction along two axes, each for itself: a pyramid, square root of two too strong between its axes. So
/// the first axis of each contact is laid along the slip, where the limit is Coulomb's. Across it friction grows with
/// the slip across, as the cone does for a slip that turns; so in steady sliding none is left there. What rests is held
/// in any direction, up to the limit along the pull of gravity and drives.
///
/// Where rest turns into sliding in a step, by pushes of other bodies, its direction is known only once the step is
/// solved. Then the step is solved again with the axis along that slip (Newton's method on the cone). Not for treels:
/// in a crowd some always begin to slip, and their direction is found in the steps that follow.
///
/// The limit is that of ODE's solver: of the load that the contact would have if nothing rubbed.
///
/// Everything is relative to the surfaces, nothing to the axes of W.
#pragma once

#include <cstddef>
#include <deque>

#include "dynamics3d/body.hpp"

namespace swarmanoid::dynamics3d {

/// Frame W. Between `startStep` and the last `isCoulombs` of a step, an OdeLock is held.
class Friction {
 public:
  /// Before the contacts of a step are made. @param step [s] @param gravity [m/s2]
  void startStep(double step, double gravity);
  /// Before they are made again, in the same order, from the same state, for `isCoulombs` was false.
  void startAgain();

  /// Lays the axes of a contact. @pre its normal, position and coefficient are set; a belt's speed and direction, if
  /// there is one, as motion1 along fdir1 @param b null: the ground
  void lay(const Body& a, dBodyID rigid_a, const Body* b, dBodyID rigid_b, dContact& contact);
  /// After `lay`: the joint that was made of the contact.
  void watch(dJointID joint);

  /// After the step was solved: whether friction is Coulomb's everywhere. If not, it is remembered where to lay axes.
  bool isCoulombs();

 private:
  /// One contact of the step.
  struct Rubbing {
    dBodyID rigid_a = nullptr;
    dBodyID rigid_b = nullptr;                          // null: does not move
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  // out of b
    Eigen::Vector3d arm_a = Eigen::Vector3d::Zero();    // from the centre of mass to the contact, before the step [m]
    Eigen::Vector3d arm_b = Eigen::Vector3d::Zero();    // likewise
    Eigen::Vector3d belt = Eigen::Vector3d::Zero();     // velocity that a would have without slip, against b [m/s]
    double coefficient = 0.0;
    double mass = 0.0;             // of the lighter one that moves [kg]
    dJointFeedback feedback = {};  // if the axis may change

    Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  // the first of friction
    double slip_per_force = 0.0;                      // across it [m/s/N]
    bool keeps_axis = false;                          // it slips already, or is a treel's: it follows from step to step
    bool is_known = false;                            // the axis, from a solution of this step
  };

  Rubbing& next();
  /// Lays the axis by what is known before the step.
  void guess(const Body& a, const Body* b, const dContact& contact, Rubbing& rubbing) const;
  /// By how much the velocity of a belt that does not slip differs from that of what it drives, before a step [m/s].
  double changeOfBelt(const Rubbing& rubbing) const;
  /// On a contact, as far as can be guessed [N].
  double usualLoad(const Rubbing& rubbing) const;
  /// Now [m/s].
  static Eigen::Vector3d slipOf(const Rubbing& rubbing);
  /// By all forces but contacts' [m/s2].
  Eigen::Vector3d pullOf(const Body* body, dBodyID rigid) const;
  static bool isCoulombs(Rubbing& rubbing);

  double step_ = 0.0;
  double gravity_ = 0.0;
  std::deque<Rubbing> rubbings_;  // ODE writes into them, so they must not move; there are never fewer
  std::size_t next_ = 0;
  bool is_again_ = false;
};

}  // namespace swarmanoid::dynamics3d
