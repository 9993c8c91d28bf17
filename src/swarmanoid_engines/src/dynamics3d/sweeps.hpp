/// Projected Gauss-Seidel with warm start, for islands of many contacts (E. Catto, Iterative Dynamics with Temporal
/// Coherence, Game Developers Conference 2005).
///
/// Each sweep corrects all contacts of an island, forwards and then backwards. The impulses of the last step are the
/// first guess, so a pressed crowd needs few sweeps. The limit of friction is that of the normal impulse of the same
/// sweep.
#pragma once

#include <vector>

#include "dynamics3d/contact_row.hpp"

namespace swarmanoid::dynamics3d {

class Sweeps {
 public:
  /// Allocates memory for islands of this many contacts.
  void reserve(std::size_t contacts) { weights_.reserve(contacts); }
  /// Solves one island. @param order indices of rows, island by island @param is_thorough whether many more sweeps are
  /// allowed @pre the velocities of the movers include the impulses of the rows
  void solve(const std::vector<std::size_t>& order, const IslandRows& island, bool is_thorough,
             std::vector<Mover>& movers, std::vector<ContactRow>& rows);

 private:
  /// Effective masses of a contact.
  struct Weight {
    double inverse_normal = 0.0;                              // along the normal [kg]
    Eigen::Matrix2d inverse_along = Eigen::Matrix2d::Zero();  // along the tangents [kg]
    double inverse_slip = 0.0;                                // lower bound of it for all directions [kg]
  };

  static Weight weigh(const ContactRow& row, const Mover& a, const Mover& b);
  /// @return largest change of the impulse as a velocity [m/s]
  static double correct(const Weight& weight, ContactRow& row, Mover& a, Mover& b);

  std::vector<Weight> weights_;  // of the island's contacts
};

}  // namespace swarmanoid::dynamics3d
