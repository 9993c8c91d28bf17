/// Coulomb's friction, as ODE can have it.
///
/// ODE limits friction along two axes, each for itself: a pyramid, square root of two too strong between its axes. So
/// the first axis of each contact is laid along the slip, where the limit is Coulomb's. Across it friction grows with
/// the slip across, as the cone does for a slip that turns; so in steady sliding none is left there. What rests is held
/// in any direction, up to the limit along the pull of gravity and drives.
///
/// ODE's exact solver limits friction by the loads that contacts would have if nothing rubbed. Loads that come from
/// friction, as that of a wall against which treels drive a robot, are unknown to it. So contacts get fixed limits, and
/// an island is solved again from the same state, with the limits that the loads of the solution give, until loads and
/// friction agree. The same passes find the direction of friction where rest turns into sliding in the step (Newton's
/// method on the cone); not for treels: in a crowd some always begin to slip, and their direction is found in the steps
/// that follow.
///
/// The first solution of a step uses the limits of the step before, so that in steady motion one solution is enough.
/// New contacts, and those without a load before, have ODE's limits in it. After entities came, went or were moved from
/// outside nothing is remembered.
///
/// What a driven robot pushes rubs along the ground only at its sides, and yields up and down: rigid bodies leave
/// undetermined how much of a load a pusher carries by friction, and here treels and ground carry all of it.
///
/// Everything is relative to the surfaces, nothing to the axes of W.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>

#include "dynamics3d/body.hpp"
#include "dynamics3d/contact_memory.hpp"
#include "dynamics3d/islands.hpp"

namespace swarmanoid::dynamics3d {

/// Whether a robot with treels touches a movable body without treels at an upright surface. @param b null: the ground
/// @param normal contact normal, in W
bool isPushed(const Body& a, const Body* b, const Eigen::Vector3d& normal);
constexpr double kYield = 1e-2;  ///< vertical slip speed per friction force where a robot pushes [m/s per N]

/// Frame W. Between `startStep` and `keep`, an OdeLock is held.
class Friction {
 public:
  /// @param memory outlives this
  explicit Friction(ContactMemory& memory) : memory_(memory) {}

  /// Begins a step. @param step time step [s] @param gravity [m/s2] @param contacts upper bound of their numbers
  /// @param uses_memory whether limits of the last step are used
  void startStep(double step, double gravity, std::size_t contacts, bool uses_memory);
  /// Begins another solution of some islands from the same state. The caller must lay their contacts again.
  void startAgain() { is_again_ = true; }

  /// Lays the axes of a contact. @param number of the contact in the step, from 0 @pre its normal, position and
  /// coefficient are set; a belt's speed and direction, if there is one, as motion1 along fdir1 @param b null: the
  /// ground
  void lay(std::size_t number, const Body& a, dBodyID rigid_a, const Body* b, dBodyID rigid_b, dContact& contact);
  /// Sets the joint of a contact. @pre `lay` was called for it
  void watch(std::size_t number, dJointID joint);

  /// Marks the islands whose solution violates Coulomb's law as astray. Their contacts get other axes and limits from
  /// the solution. Islands that are solved already are skipped. @pre the step was solved
  void markAstray(Islands& islands);

  /// After the last solution of a step: keeps its forces for the next step.
  void keep();

 private:
  /// One contact of the step.
  struct Rubbing {
    const Body* a = nullptr;  // null: no contact has this number
    std::uint64_t key = 0;
    dBodyID rigid_a = nullptr;
    dBodyID rigid_b = nullptr;                          // null: does not move
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  // out of b
    Eigen::Vector3d arm_a = Eigen::Vector3d::Zero();    // from the centre of mass to the contact, before the step [m]
    Eigen::Vector3d arm_b = Eigen::Vector3d::Zero();    // likewise
    Eigen::Vector3d belt = Eigen::Vector3d::Zero();     // velocity that a would have without slip, against b [m/s]
    double coefficient = 0.0;
    double mass = 0.0;     // of the lighter one that moves [kg]
    double holding = 0.0;  // what slips less is held [m/s]
    dJointFeedback feedback = {};

    Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  // the first of friction
    double slip_per_force = 0.0;                      // across it [m/s/N]
    bool keeps_axis = false;                          // it slips already, or is a treel's: it follows from step to step
    bool is_known = false;                            // the axis, from a solution of this step
    double limit = -1.0;                              // of friction [N]; below 0: that of ODE
  };

  /// Forgets the contacts of the last step.
  void resetRubbings();
  /// The limit that the contact had in the step before; below 0: none. @pre numbers of its calls ascend
  double recall(const Rubbing& rubbing);
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
  /// In the last solution [N].
  static double loadOf(const Rubbing& rubbing);

  ContactMemory& memory_;
  double step_ = 0.0;
  double gravity_ = 0.0;
  std::deque<Rubbing> rubbings_;     // by number; ODE writes into them, so they must not move; there are never fewer
  std::size_t contacts_ = 0;         // numbers of this step are less
  bool are_rubbings_reset_ = false;  // in this step; without joints there is no need
  bool is_again_ = false;
  bool uses_memory_ = false;
};

}  // namespace swarmanoid::dynamics3d
