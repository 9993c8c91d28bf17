// Islands of few bodies: momentum is balanced, contacts only push, and friction is Coulomb's, for any contacts.
#include "dynamics3d/newton.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;

constexpr double kExact = 1e-7;  // m/s, N s

class RandomIsland {
 public:
  RandomIsland(unsigned seed, int bodies, int contacts) : random_(seed) {
    movers.resize(static_cast<std::size_t>(bodies) + 1);
    for (std::size_t i = 1; i < movers.size(); ++i) {
      fill(movers[i]);
    }
    for (int i = 0; i < contacts; ++i) {
      rows.push_back(contact(1 + static_cast<std::size_t>(i % bodies)));
    }
    order.resize(rows.size());
    std::iota(order.begin(), order.end(), 0);
  }

  double number(double least, double most) { return std::uniform_real_distribution<double>(least, most)(random_); }
  Vector3d vector(double most) { return {number(-most, most), number(-most, most), number(-most, most)}; }

  std::vector<Mover> movers;  // element 0 is immovable
  std::vector<ContactRow> rows;
  std::vector<std::size_t> order;

 private:
  void fill(Mover& mover) {
    mover.mass = std::exp(number(-3.0, 3.0));
    mover.inverse_mass = 1.0 / mover.mass;
    const Eigen::Quaterniond turn = Eigen::Quaterniond(number(-1, 1), number(-1, 1), number(-1, 1), 0.1).normalized();
    const Vector3d principal = mover.mass * Vector3d(number(0.002, 0.01), number(0.005, 0.01), number(0.005, 0.011));
    mover.inertia = turn * principal.asDiagonal() * turn.conjugate();
    mover.inverse_inertia = mover.inertia.inverse();
    mover.linear = vector(0.3);
    mover.angular = vector(3.0);
    mover.linear_without = mover.linear;
    mover.angular_without = mover.angular;
  }

  ContactRow contact(std::size_t a) {
    ContactRow row;
    row.a = a;
    row.b = static_cast<std::size_t>(number(0.0, static_cast<double>(movers.size()) - 1e-9));
    row.b = row.b == a ? 0 : row.b;
    const Vector3d normal = (vector(1.0) + Vector3d(0.0, 0.0, 0.01)).normalized();
    const Vector3d along = normal.unitOrthogonal();
    row.axes << normal, along, normal.cross(along);
    row.arm_a = -0.1 * normal + vector(0.05);
    row.arm_b = 0.1 * normal + vector(0.05);
    row.wanted = Vector3d(number(-0.01, 0.02), number(-0.2, 0.2), 0.0);
    row.softness = Vector3d(number(0.0, 1.0) < 0.3 ? 1e-1 : 1e-4, 1e-4, number(0.0, 1.0) < 0.3 ? 1.0 : 1e-4);
    row.coefficient = number(0.0, 1.2);
    return row;
  }

  std::mt19937 random_;
};

/// Residual of the momentum balance at the velocities and impulses of a solution [m/s].
double momentumError(const RandomIsland& island) {
  double error = 0.0;
  for (std::size_t i = 1; i < island.movers.size(); ++i) {
    const Mover& mover = island.movers[i];
    Vector3d push = Vector3d::Zero();
    Vector3d turn = Vector3d::Zero();
    for (const ContactRow& row : island.rows) {
      const Vector3d on_a = row.axes * row.impulse;
      push += (row.a == i) * on_a - (row.b == i) * on_a;
      turn += (row.a == i) * row.arm_a.cross(on_a) - (row.b == i) * row.arm_b.cross(on_a);
    }
    error = std::max(error, (mover.linear_without + mover.inverse_mass * push - mover.linear).norm());
    error = std::max(error, 0.1 * (mover.angular_without + mover.inverse_inertia * turn - mover.angular).norm());
  }
  return error;
}

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
