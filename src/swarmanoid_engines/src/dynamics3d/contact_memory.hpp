/// The forces of the last step's contacts, with which the solution of the next step begins.
///
/// Each solver of a step recalls and keeps those of its own contacts, in the order in which touches are found; so a
/// contact that goes from one solver to another keeps its force.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "dynamics3d/body.hpp"

namespace swarmanoid::dynamics3d {

/// Of one contact, in W.
struct ContactForce {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< on a [N]
  double load = 0.0;                                ///< its part along the normal [N]
};

class ContactMemory {
 public:
  /// Which two bodies touch. Ground comes before pairs, both in the order of ranks.
  static std::uint64_t keyOf(const Body& a, const Body* b);

  /// After entities came, went or were moved from outside.
  void clear() { contacts_.clear(); }
  /// So many contacts there may be before memory is allocated.
  void reserve(std::size_t contacts);
  /// Before a step's first solution.
  void startStep();
  /// Before contacts are recalled in order once more.
  void rewind() { first_ = 0; }
  /// Returns the force in the contact of two bodies that was nearest to this place in the last step.
  /// @param key of both bodies, never less than in the call before @param arm_a from the centre of mass of a to the
  /// contact [m] @return null if there was none within 1 cm; valid until finishStep
  const ContactForce* recall(std::uint64_t key, dBodyID rigid_a, const Eigen::Vector3d& arm_a);

  /// Before a solver keeps its contacts.
  void startPart();
  /// @param key never less than in the call before
  void keep(std::uint64_t key, dBodyID rigid_a, const Eigen::Vector3d& arm_a, const ContactForce& force);
  /// Forgets the last step, of which this is the next.
  void finishStep();

 private:
  struct Kept {
    std::uint64_t key = 0;
    dBodyID rigid_a = nullptr;
    Eigen::Vector3d arm_a = Eigen::Vector3d::Zero();
    ContactForce force;
  };

  std::vector<Kept> contacts_;  // of the last step, by key
  std::size_t first_ = 0;       // that the next contact may be
  std::vector<Kept> parts_;     // of the step under way: of each solver, by key
  std::size_t second_ = 0;      // where the second one's begin
};

}  // namespace swarmanoid::dynamics3d
