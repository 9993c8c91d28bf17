/// Projected Gauss-Seidel with warm start, for islands of many contacts (E. Catto, Iterative Dynamics with Temporal
/// Coherence, Game Developers Conference 2005).
///
/// A sweep corrects contacts one after the other, forwards and then backwards. After a sweep over all contacts of an
/// island, some sweeps visit only those that it changed: the others are open, or hold already. The impulses of the last
/// step are the first guess, so a pressed crowd needs few sweeps. The limit of friction is that of the normal impulse
/// of the same sweep.
///
/// Contacts are sorted by levels. A contact has a higher level than the contacts before it that share a mover with it,
/// so the order by levels gives the same result, and the processor works on several contacts of a level at once.
#pragma once

#include <vector>

#include "dynamics3d/solver/contact_row.hpp"

namespace swarmanoid::dynamics3d {

class Sweeps {
 public:
  /// Allocates memory for islands of this many contacts. @param movers in the world
  void reserve(std::size_t contacts, std::size_t movers);
  /// Solves one island. @param order indices of rows, island by island @param is_thorough whether many more sweeps are
  /// allowed, to a smaller change @pre the velocities of the movers include the impulses of the rows
  void solve(const std::vector<std::size_t>& order, const IslandRows& island, bool is_thorough,
             std::vector<Mover>& movers, std::vector<ContactRow>& rows);

 private:
  // A fourth component, 0, lets the compiler use vector instructions.
  using Vector = Eigen::Vector4d;
  using Columns = Eigen::Matrix<double, 4, 3>;

  /// Velocities of a mover.
  struct Motion {
    Vector linear = Vector::Zero();   // of the centre of mass [m/s]
    Vector angular = Vector::Zero();  // [rad/s]
  };
  /// Effect of a contact on one of its movers.
  struct Lever {
    std::size_t mover = 0;
    double inverse_mass = 0.0;          // [1/kg]
    Columns turning = Columns::Zero();  // from angular velocity to velocity along the axes [m/rad]
    Columns spin = Columns::Zero();     // from impulse along the axes to angular velocity [rad/s per N s]
  };
  /// One contact, with the quantities that are the same in all sweeps.
  struct Contact {
    Lever a;
    Lever b;                                                  // unused if its mover is 0, immovable
    Columns axes = Columns::Zero();                           // in W
    Columns axes_transposed = Columns::Zero();                // from W
    Vector wanted = Vector::Zero();                           // [m/s]
    Vector softness = Vector::Zero();                         // [m/s per N s]
    Vector impulse = Vector::Zero();                          // on a [N s]
    double change = 0.0;                                      // of the last correction, as a velocity [m/s]
    double coefficient = 0.0;                                 // of friction
    double inverse_normal = 0.0;                              // effective mass along the normal [kg]
    double inverse_slip = 0.0;                                // lower bound of it along all tangents [kg]
    Eigen::Matrix2d inverse_along = Eigen::Matrix2d::Zero();  // effective mass along the tangents [kg]
  };

  void sortByLevel(const std::vector<std::size_t>& order, const IslandRows& island,
                   const std::vector<ContactRow>& rows);
  static void layLever(const Eigen::Matrix3d& axes, const Mover& mover, const Eigen::Vector3d& arm, Lever& lever,
                       Eigen::Matrix3d& velocities);
  static void prepare(const ContactRow& row, const std::vector<Mover>& movers, Contact& contact);
  Vector velocityAlong(const Contact& contact) const;
  void push(const Contact& contact, const Vector& impulse);
  double correct(Contact& contact);
  double sweep();
  void repeat(std::size_t most, double converged);
  void startMotions(const std::vector<Mover>& movers);
  void returnMotions(std::vector<Mover>& movers) const;

  std::vector<std::size_t> next_level_;  // by index of the mover
  std::vector<std::size_t> levels_;      // of the island's contacts
  std::vector<std::size_t> firsts_;      // contact of each level
  std::vector<std::size_t> sorted_;      // indices of rows, by level
  std::vector<Contact> contacts_;        // of the island, by level
  std::vector<Contact*> visited_;        // in a sweep
  std::vector<Motion> motions_;          // by index of the mover; up to date for the island's
};

}  // namespace swarmanoid::dynamics3d
