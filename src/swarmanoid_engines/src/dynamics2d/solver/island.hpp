/// Solver of dynamics2d for an island: bodies that may touch or hold each other, moved together.
///
/// Each step solves all constraints (drives, friction with the ground, grips, contacts) one after the other, again and
/// again, until no velocity changes any more. Then it moves the bodies, and pushes penetrating ones apart. All of it is
/// in double precision. A contact allows two bodies the approach that just closes their gap, so that fast bodies do not
/// tunnel.
///
/// Small islands keep nothing from tick to tick except the poses and velocities of bodies; large ones also keep the
/// contact forces (crowd_memory.hpp). Threads: one at a time for each island.
#pragma once

#include <vector>

#include "dynamics2d/solver/constraints.hpp"
#include "dynamics2d/solver/crowd_correction.hpp"

namespace swarmanoid::dynamics2d {

/// Rules for all contacts and steps of a tick.
struct IslandRules {
  double friction = 0.0;     ///< between bodies
  double restitution = 0.0;  ///< part of the speed with which bodies bounce back
  int iterations = 1;        ///< limit of sweeps in a step
};

/// Two bodies of an island that may meet in a tick.
struct BodyPair {
  int a = 0;
  int b = 0;
  /// Mirrors come first, fixed bodies last: where constraints contradict each other, the last ones are kept best.
  enum class Kind { kMirror, kMovable, kFixed } kind = Kind::kMovable;
  double approach = 0.0;  ///< upper bound, by commanded motions and those at the tick's start [m/s]
};

class Island {
 public:
  /// Data of a body for its pairs, besides its state.
  struct Outline {
    const std::vector<ContactShape>* shapes = nullptr;
    double along = 0.0;  ///< of the body's origin, along the plane's normal [m]
  };

  void clear();
  /// @return place of the body
  int add(const SolverBody& body, const Outline& outline);

  /// Contacts of the last tick, by pair. The first step starts from their impulses; the caller fills them before it.
  std::vector<ContactConstraint>& contactsOfLastTick() { return contacts_; }

  SolverBodies bodies;
  std::vector<TreelConstraint> treels;
  std::vector<SupportConstraint> supports;
  std::vector<FlightConstraint> flights;
  std::vector<GripConstraint> grips;
  std::vector<BodyPair> pairs;  ///< by kind
  double highest_speed = 0.0;   ///< of any point of a body, commanded or at the start of the tick [m/s]

  /// @param step [s]
  void move(double step, const IslandRules& rules);

  /// The smallest gap between shapes and the bodies that a body is paired with; at most `margin`, below 0 the depth of
  /// penetration [m]. @param body its place; `shapes` have its pose
  double gapAround(int body, const std::vector<ContactShape>& shapes, double margin) const;
  /// The smallest gap between the bodies of a pair; at most `margin` [m].
  double gapOf(const BodyPair& pair, double margin) const;
  /// Whether the island is solved less exactly than small ones, within a bounded time.
  bool isLarge() const;
  /// Contacts of the last step.
  const std::vector<ContactConstraint>& contacts() const { return contacts_; }

 private:
  void findContacts(double step, const IslandRules& rules);
  void findContactsOf(int pair, double step, const IslandRules& rules);
  void startFromLastStep();
  /// Number of constraints, weighted by their cost.
  std::size_t countConstraints() const;
  void solve(int most_sweeps);
  void correct();

  double reach_ = 0.0;                       // m: gaps below it are contacts in the step
  std::vector<Outline> outlines_;            // by body
  std::vector<ContactConstraint> contacts_;  // by pair
  std::vector<ContactConstraint> last_;      // of the step before
  CrowdCorrection crowd_correction_;
};

}  // namespace swarmanoid::dynamics2d
