// Islands of many bodies: momentum is balanced, contacts only push, and sweeps come near to Coulomb's law.
#include "dynamics3d/solver/sweeps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "random_island.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;

RandomIsland islandOf(int number) {
  const int bodies = 5 + number % 40;
  return {static_cast<unsigned>(number), bodies, 3 * bodies, 0.3};  // sweeps need masses that are alike
}

void solve(Sweeps& sweeps, RandomIsland& island, bool is_thorough) {
  sweeps.reserve(island.rows.size(), island.movers.size());
  sweeps.solve(island.order, {0, island.order.size()}, is_thorough, island.movers, island.rows);
}

/// @return by how much bodies come nearer than they should, or an open contact pushes [m/s, N s]
double contactError(const RandomIsland& island) {
  double error = 0.0;
  for (const ContactRow& row : island.rows) {
    const double missing = row.wanted.x() - velocityAt(row, island.movers[row.a], island.movers[row.b]).x() -
                           row.softness.x() * row.impulse.x();
    error = std::max({error, missing, std::min(row.impulse.x(), -missing)});
  }
  return error;
}

TEST(SweepsTest, BalanceMomentumAndNeverPull) {
  Sweeps sweeps;
  for (int i = 0; i < 400; ++i) {
    RandomIsland island = islandOf(i);
    SCOPED_TRACE("island " + std::to_string(i));
    solve(sweeps, island, false);
    EXPECT_LT(momentumError(island), 1e-9);
    for (const ContactRow& row : island.rows) {
      EXPECT_GE(row.impulse.x(), 0.0);
      EXPECT_LE(row.impulse.tail<2>().norm(), row.coefficient * row.impulse.x() * (1.0 + 1e-9));
    }
  }
}

TEST(SweepsTest, ContactsCloseAndOpenContactsDoNotPush) {
  Sweeps sweeps;
  int astray = 0;  // islands with friction, which may alternate where Coulomb's law has no solution
  for (int i = 0; i < 400; ++i) {
    RandomIsland island = islandOf(i);
    const bool has_friction = i % 2 == 0;
    for (ContactRow& row : island.rows) {
      row.coefficient *= has_friction ? 1.0 : 0.0;
    }
    solve(sweeps, island, true);
    const double error = contactError(island);
    if (has_friction) {
      astray += error > 1e-4 ? 1 : 0;
    } else {
      EXPECT_LT(error, 1e-4) << "island " << i;
    }
  }
  EXPECT_LE(astray, 10);
}

TEST(SweepsTest, AnIslandDoesNotDependOnTheOnesBefore) {
  Sweeps used;
  RandomIsland large = islandOf(39);
  solve(used, large, false);
  RandomIsland again = islandOf(3);
  solve(used, again, false);
  Sweeps fresh;
  RandomIsland first = islandOf(3);
  solve(fresh, first, false);
  for (std::size_t i = 0; i < first.rows.size(); ++i) {
    EXPECT_EQ(first.rows[i].impulse, again.rows[i].impulse);
  }
}

}  // namespace
}  // namespace swarmanoid::dynamics3d
