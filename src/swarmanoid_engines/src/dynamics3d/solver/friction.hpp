/// Coulomb friction within the limits of ODE.
///
/// ODE limits friction along two axes separately: a pyramid, too strong by the square root of two between its axes. So
/// the first axis of each contact is laid along the slip, where the limit is Coulomb's. Across it, friction grows with
/// the slip across, as the cone does for a slip that turns; in steady sliding there is none. Contacts at rest hold in
/// any direction, up to the limit along the pull of gravity and drives.
///
/// ODE's exact solver limits friction by the loads that contacts would have without any friction. It does not know
/// loads that come from friction, such as that of a wall against which treels drive a robot. So contacts get fixed
/// limits, and an island is solved again from the same state, with the limits that the loads of the solution give,
/// until loads and friction agree. The same passes find the direction of friction where rest turns into sliding in the
/// step (Newton's method on the cone). Treels are excepted: in a crowd some always begin to slip, and the following
/// steps find their direction.
///
/// The first solution of a step uses the limits of the step before, so that steady motion needs one solution only. New
/// contacts, and contacts without a load before, use ODE's limits in it. After entities were added, removed or placed,
/// no limits are remembered.
///
/// Where a driven robot pushes an object, friction between them is horizontal only, and yields vertically: rigid bodies
/// leave undetermined how much of a load the pusher carries by friction; here treels and ground carry all of it.
///
/// All directions are relative to the surfaces, none to the horizontal axes of W.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>

#include "dynamics3d/body.hpp"
#include "dynamics3d/contacts/contact_memory.hpp"
#include "dynamics3d/solver/islands.hpp"

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
    Eigen::Vector3d arm_b = Eigen::Vector3d::Zero();    // as arm_a
    Eigen::Vector3d belt = Eigen::Vector3d::Zero();     // velocity of a without slip, relative to b [m/s]
    double coefficient = 0.0;
    double mass = 0.0;     // of the lighter movable body [kg]
    double holding = 0.0;  // contacts that slip less are held [m/s]
    dJointFeedback feedback = {};

    Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  // first axis of friction
    double slip_per_force = 0.0;                      // across it [m/s/N]
    bool keeps_axis = false;  // in this step: the contact slips already, is a treel's, or pushes
    bool is_known = false;    // the axis comes from a solution of this step
    double limit = -1.0;      // of friction [N]; below 0: ODE's limit
  };

  /// Forgets the contacts of the last step.
  void resetRubbings();
  /// The limit of the contact in the last step; below 0: none. @pre numbers ascend from call to call
  double recall(const Rubbing& rubbing);
  /// Lays the axis by the state before the step.
  void guess(const Body& a, const Body* b, const dContact& contact, Rubbing& rubbing) const;
  /// Apparent slip of a belt that holds, from the rotation of its body before a step [m/s].
  double changeOfBelt(const Rubbing& rubbing) const;
  /// Estimated load of a contact [N].
  double usualLoad(const Rubbing& rubbing) const;
  /// Current slip velocity [m/s].
  static Eigen::Vector3d slipOf(const Rubbing& rubbing);
  /// Acceleration by all forces except contact forces [m/s2].
  Eigen::Vector3d pullOf(const Body* body, dBodyID rigid) const;
  static bool isCoulombs(Rubbing& rubbing);
  /// Load in the last solution [N].
  static double loadOf(const Rubbing& rubbing);

  ContactMemory& memory_;
  double step_ = 0.0;
  double gravity_ = 0.0;
  std::deque<Rubbing> rubbings_;     // by number; ODE writes into them, so they must not move; never shrinks
  std::size_t contacts_ = 0;         // numbers of this step are below it
  bool are_rubbings_reset_ = false;  // in this step; not needed without joints
  bool is_again_ = false;
  bool uses_memory_ = false;
};

}  // namespace swarmanoid::dynamics3d
