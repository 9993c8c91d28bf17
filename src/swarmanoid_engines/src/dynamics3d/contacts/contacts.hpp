/// Makes contacts from touches, each for the solver of its island (islands.hpp): ODE joints, or rows of the contact
/// solver. Friction of joints: friction.hpp.
#pragma once

#include <vector>

#include "dynamics3d/contacts/touches.hpp"
#include "dynamics3d/solver/contact_solver.hpp"
#include "dynamics3d/solver/friction.hpp"

namespace swarmanoid::dynamics3d {

class Contacts {
 public:
  /// @pre an OdeLock is held
  void configure(dWorldID world, const Settings& settings);
  /// Replaces the surface parameters.
  void reconfigure(const Settings& settings) { settings_ = settings; }
  /// Destroys all ODE objects. @pre an OdeLock is held
  void release();
  /// Drops the forces of the last step. The caller must do so when entities are added, removed or placed.
  void forget() { memory_.clear(); }

  /// Begins a step. @param bodies number of bodies in the world
  void startStep(std::size_t bodies);
  /// Ends a step.
  void finishStep() { memory_.finishStep(); }
  /// Makes the contacts of enabled bodies for one solution. @param step time step [s]
  /// @param attempt number of failed solutions of this step; each one breaks ties between contacts in another way
  /// @param is_iterative whether ODE's iterative solver follows, which couples loads and friction by itself
  void make(const std::vector<Touch>& touches, double step, int attempt, bool is_iterative);
  /// Makes the contacts of enabled bodies again with the corrected friction. @pre these bodies are back in the state of
  /// the last make
  void makeAgain(const std::vector<Touch>& touches);
  /// Marks the islands whose solution violates Coulomb's law as astray, and corrects their friction for makeAgain.
  void markAstray(Islands& islands) { friction_.markAstray(islands); }
  /// Stores the forces of the exact solver for the next step.
  void keepForces() { friction_.keep(); }
  /// Solves the islands of the contact solver and adds their forces to the bodies. @param is_settling true in the first
  /// steps after bodies were placed
  void solveContactIslands(bool is_settling) { solver_.solve(is_settling); }
  /// Joint group of all joints that last for one solution.
  dJointGroupID joints() const { return joints_; }
  /// Destroys the joints of that group.
  void clear() { dJointGroupEmpty(joints_); }

 private:
  void makeAll(const std::vector<Touch>& touches);
  /// @param number of the touch in the step
  void makeOne(const Touch& touch, std::size_t number);
  /// Fills everything but the friction axes. @return false if the touch makes no contact
  bool describe(const Touch& touch, dContact& contact) const;
  void breakTies(std::size_t number, dSurfaceParameters& surface) const;

  Settings settings_;
  dWorldID world_ = nullptr;
  dJointGroupID joints_ = nullptr;
  std::size_t bodies_ = 0;       // in the world
  std::size_t most_bodies_ = 0;  // that memory is allocated for
  ContactMemory memory_;
  Friction friction_{memory_};
  ContactSolver solver_{memory_};
  double step_ = 0.0;
  int attempt_ = 0;
};

}  // namespace swarmanoid::dynamics3d
