/// Islands with random bodies and contacts, for tests of solvers.
#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

#include "dynamics3d/solver/contact_row.hpp"

namespace swarmanoid::dynamics3d {

class RandomIsland {
 public:
  /// @param mass_range masses are between exp(-mass_range) and exp(mass_range) [kg]
  RandomIsland(unsigned seed, int bodies, int contacts, double mass_range = 3.0)
      : random_(seed), mass_range_(mass_range) {
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
  Eigen::Vector3d vector(double most) { return {number(-most, most), number(-most, most), number(-most, most)}; }

  std::vector<Mover> movers;  // element 0 is immovable
  std::vector<ContactRow> rows;
  std::vector<std::size_t> order;

 private:
  void fill(Mover& mover) {
    mover.mass = std::exp(number(-mass_range_, mass_range_));
    mover.inverse_mass = 1.0 / mover.mass;
    const Eigen::Quaterniond turn = Eigen::Quaterniond(number(-1, 1), number(-1, 1), number(-1, 1), 0.1).normalized();
    const Eigen::Vector3d principal =
        mover.mass * Eigen::Vector3d(number(0.002, 0.01), number(0.005, 0.01), number(0.005, 0.011));
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
    const Eigen::Vector3d normal = (vector(1.0) + Eigen::Vector3d(0.0, 0.0, 0.01)).normalized();
    const Eigen::Vector3d along = normal.unitOrthogonal();
    row.axes << normal, along, normal.cross(along);
    row.arm_a = -0.1 * normal + vector(0.05);
    row.arm_b = 0.1 * normal + vector(0.05);
    row.wanted = Eigen::Vector3d(number(-0.01, 0.02), number(-0.2, 0.2), 0.0);
    row.softness = Eigen::Vector3d(number(0.0, 1.0) < 0.3 ? 1e-1 : 1e-4, 1e-4, number(0.0, 1.0) < 0.3 ? 1.0 : 1e-4);
    row.coefficient = number(0.0, 1.2);
    return row;
  }

  std::mt19937 random_;
  double mass_range_;
};

/// Residual of the momentum balance at the velocities and impulses of a solution [m/s].
inline double momentumError(const RandomIsland& island) {
  double error = 0.0;
  for (std::size_t i = 1; i < island.movers.size(); ++i) {
    const Mover& mover = island.movers[i];
    Eigen::Vector3d push = Eigen::Vector3d::Zero();
    Eigen::Vector3d turn = Eigen::Vector3d::Zero();
    for (const ContactRow& row : island.rows) {
      const Eigen::Vector3d on_a = row.axes * row.impulse;
      push += (row.a == i) * on_a - (row.b == i) * on_a;
      turn += (row.a == i) * row.arm_a.cross(on_a) - (row.b == i) * row.arm_b.cross(on_a);
    }
    error = std::max(error, (mover.linear_without + mover.inverse_mass * push - mover.linear).norm());
    error = std::max(error, 0.1 * (mover.angular_without + mover.inverse_inertia * turn - mover.angular).norm());
  }
  return error;
}

}  // namespace swarmanoid::dynamics3d
