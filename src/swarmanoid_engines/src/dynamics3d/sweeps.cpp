#include "dynamics3d/sweeps.hpp"

#include <Eigen/LU>
#include <algorithm>

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

// Small islands converge within a step; in large crowds forces spread over some steps.
constexpr std::size_t kFewestSweeps = 20;
constexpr std::size_t kMostSweeps = 100;
constexpr std::size_t kContactsTimesSweeps = 10000;  // sets the sweeps between these two limits
constexpr std::size_t kThoroughSweeps = 300;
constexpr double kConverged = 1e-6;  // m/s

}  // namespace

Sweeps::Weight Sweeps::weigh(const ContactRow& row, const Mover& a, const Mover& b) {
  Matrix3d velocities = row.softness.asDiagonal();  // along the axes, of a unit of impulse along each
  const auto addMover = [&](const Mover& mover, const Vector3d& arm) {
    const Matrix3d turning = crossMatrix(arm).transpose() * row.axes;  // -(arm x axis)
    velocities += mover.inverse_mass * Matrix3d::Identity() + turning.transpose() * mover.inverse_inertia * turning;
  };
  addMover(a, row.arm_a);
  addMover(b, row.arm_b);
  const Matrix2d along = velocities.bottomRightCorner<2, 2>();
  return {1.0 / velocities(0, 0), along.inverse(), 1.0 / along.trace()};
}

double Sweeps::correct(const Weight& weight, ContactRow& row, Mover& a, Mover& b) {
  const Vector3d before = row.impulse;
  const Vector3d missing = row.wanted - velocityAt(row, a, b) - row.softness.cwiseProduct(before);
  row.impulse.x() = std::max(before.x() + weight.inverse_normal * missing.x(), 0.0);
  const double limit = row.coefficient * row.impulse.x();
  Vector2d along = before.tail<2>() + weight.inverse_along * missing.tail<2>();
  if (along.squaredNorm() > limit * limit) {
    // Friction of a slipping contact opposes the slip. The full effective mass would turn it away from the slip, since
    // it differs between directions.
    along = before.tail<2>() + weight.inverse_slip * missing.tail<2>();
    const double size = along.norm();
    along *= size > limit ? limit / size : 1.0;
  }
  row.impulse.tail<2>() = along;
  const Vector3d change = row.impulse - before;
  push(row, change, a, b);
  return change.cwiseAbs().maxCoeff() / weight.inverse_normal;
}

void Sweeps::solve(const std::vector<std::size_t>& order, const IslandRows& island, bool is_thorough,
                   std::vector<Mover>& movers, std::vector<ContactRow>& rows) {
  weights_.clear();
  for (std::size_t i = island.first; i < island.last; ++i) {
    const ContactRow& row = rows[order[i]];
    weights_.push_back(weigh(row, movers[row.a], movers[row.b]));
  }
  const std::size_t contacts = std::max<std::size_t>(island.last - island.first, 1);
  const std::size_t most =
      is_thorough ? kThoroughSweeps : std::clamp(kContactsTimesSweeps / contacts, kFewestSweeps, kMostSweeps);
  double change = 0.0;  // m/s
  const auto visit = [&](std::size_t place) {
    ContactRow& row = rows[order[place]];
    change = std::max(change, correct(weights_[place - island.first], row, movers[row.a], movers[row.b]));
  };
  for (std::size_t sweep = 0; sweep < most; ++sweep) {
    change = 0.0;
    for (std::size_t i = island.first; i < island.last; ++i) {
      visit(i);
    }
    for (std::size_t i = island.last; i > island.first; --i) {
      visit(i - 1);
    }
    if (change <= kConverged) {
      return;
    }
  }
}

}  // namespace swarmanoid::dynamics3d
