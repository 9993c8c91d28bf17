/// Position correction of large islands: moves penetrating bodies apart.
///
/// Gaps are linear in small displacements. A round computes all gaps and their gradients once, then sweeps over the
/// contacts and pushes each pair of bodies apart until no contact is deeper than allowed. A round ends early when a
/// body has moved so far that the gaps must be computed again.
///
/// Axes of the plane, SI units. Threads: one at a time for each object.
#pragma once

#include <vector>

#include "dynamics2d/solver/constraints.hpp"

namespace swarmanoid::dynamics2d {

class CrowdCorrection {
 public:
  /// Moves the bodies apart. Velocities stay as they are. @param allowed depth that may remain [m]
  void correct(SolverBodies& bodies, const std::vector<ContactConstraint>& contacts, double allowed);

 private:
  /// Displacement of a body in a round.
  struct Displacement {
    double x = 0.0;  // m
    double y = 0.0;
    double turn = 0.0;  // rad
    double inverse_mass = 0.0;
    double inverse_inertia = 0.0;
    int last_sweep = 0;  // that pushed it
  };

  /// One point of a contact.
  struct Row {
    std::size_t a = 0;
    std::size_t b = 0;
    double x = 0.0;  // normal, from a to b
    double y = 0.0;
    double lever_a = 0.0;  // cross product of arm and normal [m]
    double lever_b = 0.0;
    double mass = 0.0;   // impulse per depth [kg]
    double depth = 0.0;  // without displacements, beyond the allowed depth [m]
  };

  /// Computes the rows of the contacts that the displacements of a round can close. @return the largest depth [m]
  double linearise(const SolverBodies& bodies, const std::vector<ContactConstraint>& contacts);
  /// Pushes bodies apart that are deeper than allowed, contact by contact. @param number of the sweep in the round,
  /// from 1 @param relaxation how many times the depth a push opens @return whether there were any
  bool sweep(int number, double allowed, double relaxation);
  /// Whether gaps must be computed again.
  bool isFar(const SolverBodies& bodies) const;
  void apply(SolverBodies& bodies) const;

  std::vector<Row> rows_;
  std::vector<Displacement> displacements_;  // by body
};

}  // namespace swarmanoid::dynamics2d
