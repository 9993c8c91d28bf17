/// Solver for islands that only contacts connect (islands.hpp): Newton's method for few bodies (newton.hpp), sweeps for
/// many (sweeps.hpp). An island does not depend on the other islands.
///
/// The solver adds its forces to the ODE bodies; ODE integrates them.
#pragma once

#include <cstdint>
#include <vector>

#include "dynamics3d/body.hpp"
#include "dynamics3d/contacts/contact_memory.hpp"
#include "dynamics3d/solver/contact_row.hpp"
#include "dynamics3d/solver/newton.hpp"
#include "dynamics3d/solver/sweeps.hpp"

namespace swarmanoid::dynamics3d {

/// Frame W. From `startStep` to `solve` an OdeLock is held.
class ContactSolver {
 public:
  /// @param memory outlives this
  explicit ContactSolver(ContactMemory& memory) : memory_(memory) {}

  /// Begins a step without contacts. @param step time step [s] @param bodies number of bodies in the world
  void startStep(dWorldID world, double step, std::size_t bodies);
  /// Adds a contact. The first one of a run allocates memory for all. @param b null: the ground @param contact surface
  /// without friction axes; a belt has its speed in motion1, along fdir1 @pre both bodies are enabled and have no links
  void add(const Body& a, const Body* b, const dContact& contact);
  /// Solves the step and adds the contact forces to the bodies. @param is_settling true in the first steps after bodies
  /// were placed: allows many more sweeps, since grips may close on these poses @pre called once a step
  void solve(bool is_settling);

 private:
  void startMovers();
  std::size_t moverOf(const Body* body);
  void layAxes(const Body& a, const Body* b, const dContact& contact, ContactRow& row) const;
  void wantVelocity(const dContact& contact, ContactRow& row) const;
  void recall(ContactRow& row);
  void sortByIslands();
  void addForces() const;
  void keep();

  ContactMemory& memory_;
  dWorldID world_ = nullptr;
  double step_ = 0.0;                   // [s]
  std::size_t bodies_ = 0;              // in the world
  std::vector<ContactRow> rows_;        // of this step; if empty, the members below are out of date
  std::vector<Mover> movers_;           // element 0 stands for everything immovable
  std::vector<std::size_t> by_rank_;    // index into movers_; 0: not added
  std::vector<std::size_t> order_;      // indices into rows_, island by island
  std::vector<IslandRows> islands_;     // by the rank of the first body; empty for other ranks
  std::vector<std::size_t> bodies_of_;  // movable bodies of the island, by the rank of its first body
  Sweeps sweeps_;
  Newton newton_;
};

}  // namespace swarmanoid::dynamics3d
