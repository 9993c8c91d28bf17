/// Contact forces of the last step, which warm-start the solvers of the next one.
///
/// Each solver recalls and stores the forces of its own contacts, in the order of the touches of the step. A contact
/// that moves from one solver to another keeps its force.
#pragma once

#include <cstdint>
#include <vector>

#include "dynamics3d/body.hpp"

namespace swarmanoid::dynamics3d {

/// Force in one contact, in W.
struct ContactForce {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< on a [N]
  double load = 0.0;                                ///< its part along the normal [N]
};

class ContactMemory {
 public:
  /// Key of two touching bodies; ascends in the order of the touches: ground contacts by rank, then pairs by their
  /// ranks. @param b null: the ground
  static std::uint64_t keyOf(const Body& a, const Body* b);

  /// Forgets all forces. The caller must do so when entities are added, removed or placed.
  void clear() { contacts_.clear(); }
  /// Allocates memory for this many contacts.
  void reserve(std::size_t contacts);
  /// Begins a step.
  void startStep();
  /// Restarts the recall at the first contact, for another solution of the step.
  void rewind() { first_ = 0; }
  /// Returns the force of the last step's nearest contact of the same two bodies.
  /// @param key keyOf the bodies; must not be less than in the previous call @param arm_a from the centre of mass of a
  /// to the contact, in W [m] @return null without a contact within 1 cm; valid until finishStep
  const ContactForce* recall(std::uint64_t key, dBodyID rigid_a, const Eigen::Vector3d& arm_a);

  /// Begins the contacts of one solver.
  void startPart();
  /// Stores the force of a contact. @param key must not be less than in the previous call for this solver
  void keep(std::uint64_t key, dBodyID rigid_a, const Eigen::Vector3d& arm_a, const ContactForce& force);
  /// Ends a step: replaces the forces of the last step.
  void finishStep();

 private:
  struct Kept {
    std::uint64_t key = 0;
    dBodyID rigid_a = nullptr;
    Eigen::Vector3d arm_a = Eigen::Vector3d::Zero();
    ContactForce force;
  };

  std::vector<Kept> contacts_;  // of the last step, by key
  std::size_t first_ = 0;       // first candidate for the next recall
  std::vector<Kept> parts_;     // of this step: up to two solvers, each by key
  std::size_t second_ = 0;      // begin of the second solver's contacts
};

}  // namespace swarmanoid::dynamics3d
