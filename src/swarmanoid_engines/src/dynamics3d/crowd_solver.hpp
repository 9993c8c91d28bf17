/// Solver for islands of many contacts and no other joints (islands.hpp).
///
/// Projected Gauss-Seidel on impulses, with warm start (E. Catto, Iterative Dynamics with Temporal Coherence, Game
/// Developers Conference 2005): each sweep corrects all contacts of an island, forwards and then backwards. The first
/// sweep starts from the forces of the last step, so a pressed crowd needs few sweeps. ODE's iterative solver starts
/// from zero in each step. Islands have separate sweeps; an island does not depend on the other islands.
///
/// Depth correction, softness and bounce are those of ODE's contact joints. Coulomb friction is limited on a circle by
/// the normal impulse of the same sweep.
///
/// The solver adds its forces to the ODE bodies; ODE integrates them.
#pragma once

#include <cstdint>
#include <vector>

#include "dynamics3d/body.hpp"
#include "dynamics3d/contact_memory.hpp"

namespace swarmanoid::dynamics3d {

/// Frame W. From `startStep` to `solve` an OdeLock is held.
class CrowdSolver {
 public:
  /// @param memory outlives this
  explicit CrowdSolver(ContactMemory& memory) : memory_(memory) {}

  /// Begins a step without contacts. @param step time step [s] @param bodies number of bodies in the world
  void startStep(dWorldID world, double step, std::size_t bodies);
  /// Adds a contact. The first one of a run allocates memory for all. @param b null: the ground @param contact surface
  /// without friction axes; a belt has its speed in motion1, along fdir1 @pre both bodies are enabled and have no links
  void add(const Body& a, const Body* b, const dContact& contact);
  /// Solves the step and adds the contact forces to the bodies. @param is_settling true in the first steps after bodies
  /// were placed: allows many more sweeps, since grips may close on these poses @pre called once a step
  void solve(bool is_settling);

 private:
  /// A body with its velocities under the impulses of the current sweep, in W.
  struct Mover {
    dBodyID rigid = nullptr;
    double inverse_mass = 0.0;                                  // 0: infinite mass [1/kg]
    Eigen::Matrix3d inverse_inertia = Eigen::Matrix3d::Zero();  // [1/(kg m2)]
    Eigen::Vector3d linear = Eigen::Vector3d::Zero();           // [m/s]
    Eigen::Vector3d angular = Eigen::Vector3d::Zero();          // [rad/s]
    Eigen::Vector3d linear_without = Eigen::Vector3d::Zero();   // end of step without contacts [m/s]
    Eigen::Vector3d angular_without = Eigen::Vector3d::Zero();  // [rad/s]
  };

  /// One contact. Vectors are along its axes: normal out of b, then two tangents.
  struct Contact {
    std::uint64_t key = 0;
    std::size_t island = 0;
    std::size_t a = 0;  // in movers_
    std::size_t b = 0;
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // columns, in W
    Eigen::Vector3d arm_a = Eigen::Vector3d::Zero();     // centre of mass to contact, in W [m]
    Eigen::Vector3d arm_b = Eigen::Vector3d::Zero();
    Eigen::Vector3d wanted = Eigen::Vector3d::Zero();         // target velocity of a relative to b [m/s]
    Eigen::Vector3d softness = Eigen::Vector3d::Zero();       // velocity error per impulse [m/s per N s]
    double inverse_normal = 0.0;                              // effective mass along the normal [kg]
    Eigen::Matrix2d inverse_along = Eigen::Matrix2d::Zero();  // effective mass along the tangents [kg]
    double inverse_slip = 0.0;                                // lower bound of it for all directions [kg]
    double coefficient = 0.0;                                 // of friction
    Eigen::Vector3d impulse = Eigen::Vector3d::Zero();        // on a [N s]
  };

  /// Contacts of one island: [first, last) in order_.
  struct Range {
    std::size_t first = 0;
    std::size_t last = 0;
  };

  void startMovers();
  std::size_t moverOf(const Body* body);
  void layAxes(const Body& a, const Body* b, const dContact& contact, Contact& laid) const;
  void wantVelocity(const dContact& ode, Contact& contact) const;
  void weigh(Contact& contact) const;
  void recall(Contact& contact);
  void keep();
  Eigen::Vector3d velocityAt(const Contact& contact) const;
  void push(const Contact& contact, const Eigen::Vector3d& impulse);
  /// @return largest change of the impulse as a velocity [m/s]
  double correct(Contact& contact);
  /// @return largest return value of correct [m/s]
  double sweep(const Range& range);
  void sortByIslands();

  ContactMemory& memory_;
  dWorldID world_ = nullptr;
  double step_ = 0.0;                 // [s]
  std::size_t bodies_ = 0;            // in the world
  std::vector<Contact> contacts_;     // of this step; if it is empty, what follows is not up to date
  std::vector<Mover> movers_;         // element 0 stands for everything immovable
  std::vector<std::size_t> by_rank_;  // index into movers_; 0: not added
  std::vector<std::size_t> order_;    // indices into contacts_, island by island
  std::vector<Range> islands_;        // by the rank of the first body; empty for other ranks
};

}  // namespace swarmanoid::dynamics3d
