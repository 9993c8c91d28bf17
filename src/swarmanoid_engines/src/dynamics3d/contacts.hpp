/// Makes contacts of where bodies touch, each for the solver of its island (islands.hpp): joints of ODE, or contacts of
/// the crowd solver.
///
/// Friction is that of friction.hpp, and in crowds that of crowd_solver.hpp.
#pragma once

#include <vector>

#include "dynamics3d/crowd_solver.hpp"
#include "dynamics3d/friction.hpp"
#include "dynamics3d/touches.hpp"

namespace swarmanoid::dynamics3d {

class Contacts {
 public:
  /// @pre an OdeLock is held
  void configure(dWorldID world, const Settings& settings);
  /// Other surfaces from now on.
  void reconfigure(const Settings& settings) { settings_ = settings; }
  /// Gives everything back to ODE. @pre an OdeLock is held
  void release();
  /// After entities came, went or were moved from outside.
  void forget() { memory_.clear(); }

  /// Before the contacts of a step are made. @param room for so many contacts there is to be @param bodies how many
  /// there are
  void startStep(std::size_t room, std::size_t bodies);
  /// After it was solved.
  void finishStep() { memory_.finishStep(); }
  /// Makes the contacts of one solution, of bodies that are enabled. @param step [s]
  /// @param attempt counts up while the solver fails: ties between contacts are then broken in another way
  /// @param is_iterative whether the iterative solver makes the step, which finds loads and friction together
  void make(const std::vector<Touch>& touches, double step, int attempt, bool is_iterative);
  /// After the step was solved: whether friction is Coulomb's everywhere.
  bool isFrictionCoulombs() { return friction_.isCoulombs(); }
  /// After the last solution of a step by the exact solver: keeps its forces for the next step.
  void keepForces() { friction_.keep(); }
  /// Makes the contacts once more, now with the friction that was found. @pre the bodies are back in the state of the
  /// last make
  void makeAgain(const std::vector<Touch>& touches);
  /// Finds the forces in crowds, and puts them on their bodies for ODE's next step. @param is_settling whether bodies
  /// were just put down
  void solveCrowds(bool is_settling) { crowds_.solve(is_settling); }
  /// Where joints belong that are to last for one step.
  dJointGroupID joints() const { return joints_; }
  /// Forgets them again.
  void clear() { dJointGroupEmpty(joints_); }

 private:
  void makeAll(const std::vector<Touch>& touches);
  void makeOne(const Touch& touch);
  /// All but friction's axes. @return whether there is a contact
  bool describe(const Touch& touch, dContact& contact) const;
  void breakTies(dSurfaceParameters& surface);

  Settings settings_;
  dWorldID world_ = nullptr;
  dJointGroupID joints_ = nullptr;
  std::size_t reserved_ = 0;  // contacts
  std::size_t bodies_ = 0;
  ContactMemory memory_;
  Friction friction_{memory_};
  CrowdSolver crowds_{memory_};
  double step_ = 0.0;
  int joints_made_ = 0;  // in this step
  int attempt_ = 0;
};

}  // namespace swarmanoid::dynamics3d
