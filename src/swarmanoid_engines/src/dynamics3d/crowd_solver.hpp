/// Finds the forces between bodies that many contacts connect and nothing else holds together (islands.hpp).
///
/// Impulses are found contact after contact, in sweeps there and back over all of them: each contact gets the impulse
/// that gives it the velocity it is to have, with all others as they are (projected Gauss-Seidel; E. Catto, Iterative
/// Dynamics with Temporal Coherence, Game Developers Conference 2005). A step begins with the impulses of the step
/// before, so a crowd that presses goes on where it was, and a few sweeps a step are enough. ODE's own iterative solver
/// begins from nothing in each step. Each island has its own sweeps, so it moves as if the others were not there.
///
/// Contacts are those that ODE would get: the same correction of depths, softness and bounce. Friction is limited on a
/// circle by the load of the same sweep (Coulomb).
///
/// Forces that were found are put on the bodies, and ODE moves them.
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

  /// So many contacts there may be before memory is allocated.
  void reserve(std::size_t contacts);
  /// Before the contacts of a step are added. @param step [s] @param bodies how many there are
  void startStep(dWorldID world, double step, std::size_t bodies);
  /// @param b null: the ground @param contact whose axes of friction are not laid; a belt's speed and direction, if
  /// there is one, as motion1 along fdir1 @pre both bodies have one rigid body at most, and the step moves them
  void add(const Body& a, const Body* b, const dContact& contact);
  /// Adds the contacts' forces to those of the bodies. @param is_settling whether bodies were just put down, so that
  /// the forces must be right at once and not after some steps @pre called once a step, after all contacts were added
  void solve(bool is_settling);

 private:
  /// A body, as it moves if the contacts give it the impulses of the sweep under way.
  struct Mover {
    dBodyID rigid = nullptr;
    double inverse_mass = 0.0;                                  // 0: contacts do not move it [1/kg]
    Eigen::Matrix3d inverse_inertia = Eigen::Matrix3d::Zero();  // [1/(kg m2)]
    Eigen::Vector3d linear = Eigen::Vector3d::Zero();           // [m/s]
    Eigen::Vector3d angular = Eigen::Vector3d::Zero();          // [rad/s]
    Eigen::Vector3d linear_without = Eigen::Vector3d::Zero();   // contacts, at the end of the step [m/s]
    Eigen::Vector3d angular_without = Eigen::Vector3d::Zero();  // [rad/s]
  };

  /// One contact. Vectors are along its axes: the normal, out of b, and two along the surface.
  struct Contact {
    std::uint64_t key = 0;
    std::size_t island = 0;
    std::size_t a = 0;  // in movers_
    std::size_t b = 0;
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // columns, in W
    Eigen::Vector3d arm_a = Eigen::Vector3d::Zero();     // from the centre of mass, in W [m]
    Eigen::Vector3d arm_b = Eigen::Vector3d::Zero();
    Eigen::Vector3d wanted = Eigen::Vector3d::Zero();         // velocity of a against b [m/s]
    Eigen::Vector3d softness = Eigen::Vector3d::Zero();       // by how much it is missed [m/s per N s]
    double inverse_normal = 0.0;                              // impulse for a velocity along the normal [kg]
    Eigen::Matrix2d inverse_along = Eigen::Matrix2d::Zero();  // along the surface [kg]
    double inverse_slip = 0.0;                          // the same in any direction, not too much in the stiffest [kg]
    double coefficient = 0.0;                           // of friction
    Eigen::Vector3d impulse = Eigen::Vector3d::Zero();  // on a [N s]
  };

  /// The contacts of an island, in order_: from first, before last.
  struct Range {
    std::size_t first = 0;
    std::size_t last = 0;
  };

  std::size_t moverOf(const Body* body);
  void layAxes(const Body& a, const Body* b, const dContact& contact, Contact& laid) const;
  void wantVelocity(const dContact& ode, Contact& contact) const;
  void weigh(Contact& contact) const;
  void recall(Contact& contact);
  void keep();
  Eigen::Vector3d velocityAt(const Contact& contact) const;
  void push(const Contact& contact, const Eigen::Vector3d& impulse);
  /// @return by how much its velocity was astray [m/s]
  double correct(Contact& contact);
  /// @return the largest of all
  double sweep(const Range& range);
  void sortByIslands();

  ContactMemory& memory_;
  dWorldID world_ = nullptr;
  double step_ = 0.0;
  std::vector<Mover> movers_;         // the first one stands for all that does not move
  std::vector<std::size_t> by_rank_;  // places in movers_; 0: none yet
  std::vector<Contact> contacts_;
  std::vector<std::size_t> order_;  // places in contacts_, island by island
  std::vector<Range> islands_;      // by the rank of their first body; of others nothing
};

}  // namespace swarmanoid::dynamics3d
