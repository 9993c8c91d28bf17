/// The solver of dynamics2d: bodies that may touch each other or hold each other, moved together.
///
/// In each step all constraints (drives, friction with the ground, grips, contacts) are solved one after the other,
/// again and again, until no velocity changes any more; then bodies are moved, and pushed apart where they are in each
/// other. All of it is in double precision. A contact leaves two bodies the approach that just closes their gap, so
/// nothing is overlooked that is faster than a step is short.
///
/// Small islands keep nothing from tick to tick but the poses and velocities of bodies; large ones keep the forces in
/// contacts, too (crowd_memory.hpp). Threads: one at a time for each island.
#pragma once

#include <vector>

#include "dynamics2d/constraints.hpp"
#include "dynamics2d/crowd_correction.hpp"

namespace swarmanoid::dynamics2d {

/// What holds for all contacts and steps of a tick.
struct IslandRules {
  double friction = 0.0;     ///< between bodies
  double restitution = 0.0;  ///< part of the speed with which bodies bounce back
  int iterations = 1;        ///< at most, in a step
};

/// Two bodies of an island that may meet in a tick.
struct BodyPair {
  int a = 0;
  int b = 0;
  /// Mirrors come first, what is fixed last: the last ones are held to best where they contradict each other.
  enum class Kind { kMirror, kMovable, kFixed } kind = Kind::kMovable;
  double approach = 0.0;  ///< at most, by the motions that are commanded and those of the tick's start [m/s]
};

class Island {
 public:
  /// What a pair needs of a body besides its state.
  struct Outline {
    const std::vector<ContactShape>* shapes = nullptr;
    double along = 0.0;  ///< of the body's origin, along the plane's normal [m]
  };

  void clear();
  /// @return its place
  int add(const SolverBody& body, const Outline& outline);

  /// Contacts of the last tick, by pair, from whose impulses the first step starts; the caller fills them before it.
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

  /// The smallest gap between shapes and those of the bodies that a body is paired with; at most `margin`, below 0 how
  /// deep they are in each other [m]. @param body its place: the shapes are where it is
  double gapAround(int body, const std::vector<ContactShape>& shapes, double margin) const;
  /// The smallest gap between the bodies of a pair; at most `margin` [m].
  double gapOf(const BodyPair& pair, double margin) const;
  /// Whether it is solved less exactly than small ones, within a bounded time.
  bool isLarge() const;
  /// Those of the last step.
  const std::vector<ContactConstraint>& contacts() const { return contacts_; }

 private:
  void findContacts(double step, const IslandRules& rules);
  void findContactsOf(int pair, double step, const IslandRules& rules);
  void startFromLastStep();
  /// By what they cost.
  std::size_t countConstraints() const;
  void solve(int most_sweeps);
  void correct();

  double reach_ = 0.0;                       // m: gaps below it are contacts in the step
  std::vector<Outline> outlines_;            // by body
  std::vector<ContactConstraint> contacts_;  // by pair
  std::vector<ContactConstraint> last_;      // those of the step before
  CrowdCorrection crowd_correction_;
};

}  // namespace swarmanoid::dynamics2d
