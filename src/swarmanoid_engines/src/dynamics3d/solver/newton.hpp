/// Newton's method for islands of few bodies that only contacts connect: loads and friction are solved together, with
/// Coulomb's cone.
///
/// The unknowns are the velocities of the bodies at the end of the step (momentum_balance.hpp). Contacts are soft, so
/// each impulse is a function of the velocities, with kinks where a contact opens or begins to slip; the method is
/// semi-smooth (L. Qi and J. Sun, A nonsmooth version of Newton's method, Mathematical Programming 58, 1993). It starts
/// from the solution under the assumption that the same contacts press and slip as in the last step. Where it does not
/// converge, limits of friction are fixed, which is a convex problem, and follow the loads of each solution until both
/// agree.
///
/// Coulomb's law need not have a solution (P. Painleve's paradox). Friction of such islands is that of loads which
/// alternate from one solution to the next. Threads: one at a time for each object.
#pragma once

#include <array>
#include <vector>

#include "dynamics3d/contacts/touches.hpp"
#include "dynamics3d/solver/momentum_balance.hpp"

namespace swarmanoid::dynamics3d {

class Newton {
 public:
  /// Allocates all memory.
  void reserve();
  /// Solves one island: sets the impulses of its rows and the velocities of its movers. @param order indices of rows,
  /// island by island @pre the velocities of the movers include the impulses of the rows; at most kMostNewtonBodies
  /// bodies of the island are movable
  /// @return false if the island has very many contacts, or the method did not converge; rows and movers are then as
  /// before
  bool solve(const std::vector<std::size_t>& order, const IslandRows& island, std::vector<Mover>& movers,
             std::vector<ContactRow>& rows);

 private:
  static constexpr std::size_t kMostRows = kMostTouchesOfABody * kMostNewtonBodies;
  using Limits = std::array<double, kMostRows>;  // of friction, by row [N s]

  int unknownsOf(std::size_t mover, const std::vector<Mover>& movers);
  void addRow(ContactRow& contact, const std::vector<Mover>& movers);
  template <int kUnknowns>
  bool solveAs(std::vector<Mover>& movers);

  template <class Balance>
  static typename Balance::Unknowns predictedChange(Balance& balance, const typename Balance::Unknowns& start);
  /// @return false if it did not converge
  template <class Balance>
  static bool iterateCoupled(Balance& balance, typename Balance::Unknowns& velocities);
  template <class Balance>
  static bool iterateFixed(Balance& balance, typename Balance::Unknowns& velocities);
  template <class Balance>
  static bool solveByLimits(Balance& balance, typename Balance::Unknowns& velocities);
  /// Returns the share of a change that makes the energy nearly least. @pre limits are fixed
  template <class Balance>
  static double shareOf(const Balance& balance, const typename Balance::Unknowns& change,
                        const typename Balance::Unknowns& missing);
  /// Moves limits towards those of the loads. @return whether they are equal
  static bool followLoads(const std::vector<BalanceRow>& rows, double share, Limits& limits);

  std::vector<BalanceRow> rows_;
  std::vector<std::size_t> bodies_;  // movers of the island, in the order of the unknowns
};

}  // namespace swarmanoid::dynamics3d
