// Islands of few bodies: momentum is balanced, contacts only push, and friction is Coulomb's, for any contacts.
#include "dynamics3d/solver/newton.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "random_island.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;

constexpr double kExact = 1e-7;  // m/s, N s

/// Expects that contacts only push, and only where they do not open.
void expectContactsPush(const RandomIsland& island) {
  for (const ContactRow& row : island.rows) {
    const double missing = row.wanted.x() - velocityAt(row, island.movers[row.a], island.movers[row.b]).x() -
                           row.softness.x() * row.impulse.x();
    EXPECT_GE(row.impulse.x(), 0.0);
    EXPECT_LE(missing, kExact) << "bodies come nearer";
    EXPECT_LE(std::min(row.impulse.x(), -missing), kExact) << "a contact that opens pushes";
  }
}

bool isCoulombs(const ContactRow& row, const std::vector<Mover>& movers) {
  const Vector3d missing =
      row.wanted - velocityAt(row, movers[row.a], movers[row.b]) - row.softness.cwiseProduct(row.impulse);
  const Eigen::Vector2d slip = -missing.tail<2>();
  const Eigen::Vector2d friction = row.impulse.tail<2>();
  const double limit = row.coefficient * row.impulse.x();
  const double speed = slip.norm();
  const double tolerated = 1e-3 * limit + kExact;
  return speed < 1e-5 ? friction.norm() <= limit + tolerated : (friction + limit / speed * slip).norm() <= tolerated;
}

TEST(NewtonTest, SolutionsObeyCoulombsLaw) {
  // Coulomb's law need not have a solution (Painleve); in such islands friction alternates
  constexpr int kIslands = 2000;
  Newton newton;
  newton.reserve();
  int astray = 0;
  int unsolved = 0;
  for (int i = 0; i < kIslands; ++i) {
    const int bodies = 1 + i % static_cast<int>(kMostNewtonBodies);
    RandomIsland island(static_cast<unsigned>(i), bodies, 1 + (i / 7) % (5 * bodies));
    SCOPED_TRACE("island " + std::to_string(i));
    if (!newton.solve(island.order, {0, island.order.size()}, island.movers, island.rows)) {
      ++unsolved;
      continue;
    }
    EXPECT_LT(momentumError(island), kExact);
    expectContactsPush(island);
    const auto obeys = [&](const ContactRow& row) { return isCoulombs(row, island.movers); };
    astray += std::all_of(island.rows.begin(), island.rows.end(), obeys) ? 0 : 1;
  }
  EXPECT_LE(astray, 30);
  EXPECT_LE(unsolved, 3);
}

TEST(NewtonTest, ABlockThatIsPushedTipsWhereAHandComputationSaysSo) {
  // 0.2 m wide, 0.6 m high, on two contacts that do not slip: tips if the push's moment exceeds the weight times half
  // the width
  constexpr double kStep = 0.01;
  constexpr double kMass = 1.7;
  constexpr double kGravity = 9.81;
  for (const double share : {0.97, 1.03}) {
    Mover block;
    block.mass = kMass;
    block.inverse_mass = 1.0 / kMass;
    block.inertia = 0.05 * Eigen::Matrix3d::Identity();
    block.inverse_inertia = block.inertia.inverse();
    const double push = share * kMass * kGravity * 0.1 / 0.3;  // N, along x at the height of the centre of mass
    block.linear_without = kStep * Vector3d(push / kMass, 0.0, -kGravity);
    block.linear = block.linear_without;
    std::vector<Mover> movers{Mover{}, block};
    std::vector<ContactRow> rows(4);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i].a = 1;
      rows[i].axes << Vector3d::UnitZ(), Vector3d::UnitX(), Vector3d::UnitY();
      rows[i].arm_a = {i % 2 == 0 ? 0.1 : -0.1, i / 2 == 0 ? 0.1 : -0.1, -0.3};
      rows[i].softness.setConstant(1e-6);
      rows[i].coefficient = 0.9;
    }
    Newton newton;
    ASSERT_TRUE(newton.solve({0, 1, 2, 3}, {0, 4}, movers, rows));
    const double load = rows[0].impulse.x() + rows[1].impulse.x() + rows[2].impulse.x() + rows[3].impulse.x();
    if (share < 1.0) {
      EXPECT_LT(movers[1].angular.norm(), 1e-5);
      EXPECT_NEAR(load, kStep * kMass * kGravity, 1e-6);
      EXPECT_NEAR((rows[0].impulse.x() + rows[2].impulse.x()) / load, 0.5 * (1.0 + share), 1e-4);
    } else {
      // about the edge: 0.03 of the tipping moment over the inertia there
      const double moment = 0.03 * kMass * kGravity * 0.1;
      const double inertia = 0.05 + kMass * (0.1 * 0.1 + 0.3 * 0.3);
      EXPECT_NEAR(movers[1].angular.y(), kStep * moment / inertia, 1e-3 * kStep * moment / inertia);
      EXPECT_EQ(rows[1].impulse.x(), 0.0);
    }
  }
}

}  // namespace
}  // namespace swarmanoid::dynamics3d
