#include "dynamics3d/solver/newton.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

BalanceRow::Momenta momentaOf(const ContactRow& contact, const Vector3d& arm, double sign) {
  BalanceRow::Momenta momenta;
  for (int i = 0; i < 3; ++i) {
    const Vector3d axis = sign * contact.axes.col(i);
    momenta.col(i) << axis, arm.cross(axis);
  }
  return momenta;
}

/// Returns the velocity that a contact would miss with the impulse of the last step. @param slip speed if it slips
/// [m/s]
Vector3d expectedOf(const ContactRow& contact, double slip) {
  constexpr double kAtLimit = 0.999;
  Vector3d expected = contact.softness.cwiseProduct(contact.impulse);
  const double friction = contact.impulse.tail<2>().norm();
  if (friction > 0.0 && friction >= kAtLimit * contact.coefficient * contact.impulse.x()) {
    expected.tail<2>() = std::max(slip, 2.0 * expected.tail<2>().norm()) / friction * contact.impulse.tail<2>();
  }
  return expected;
}

template <class Range>
void setLimits(const Range& limits, std::vector<BalanceRow>& rows) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].limit = limits[i];
  }
}

void coupleLimits(std::vector<BalanceRow>& rows) {
  for (BalanceRow& row : rows) {
    row.limit = -1.0;
  }
}

}  // namespace

void Newton::reserve() {
  rows_.reserve(kMostRows);
  bodies_.reserve(kMostNewtonBodies);
}

bool Newton::solve(const std::vector<std::size_t>& order, const IslandRows& island, std::vector<Mover>& movers,
                   std::vector<ContactRow>& rows) {
  if (island.last - island.first > kMostRows) {
    return false;
  }
  bodies_.clear();
  rows_.clear();
  for (std::size_t i = island.first; i < island.last; ++i) {
    addRow(rows[order[i]], movers);
  }
  SWARMANOID_EXPECTS(bodies_.size() <= kMostNewtonBodies);
  return bodies_.size() == 1 ? solveAs<kUnknownsOfABody>(movers) : solveAs<Eigen::Dynamic>(movers);
}

int Newton::unknownsOf(std::size_t mover, const std::vector<Mover>& movers) {
  if (movers[mover].mass == 0.0) {
    return -1;
  }
  const auto place = std::find(bodies_.begin(), bodies_.end(), mover);
  const auto index = static_cast<int>(place - bodies_.begin());
  if (place == bodies_.end()) {
    bodies_.push_back(mover);
  }
  return kUnknownsOfABody * index;
}

void Newton::addRow(ContactRow& contact, const std::vector<Mover>& movers) {
  BalanceRow& row = rows_.emplace_back();
  row.contact = &contact;
  row.a = unknownsOf(contact.a, movers);
  row.b = unknownsOf(contact.b, movers);
  row.on_a = momentaOf(contact, contact.arm_a, 1.0);
  row.on_b = momentaOf(contact, contact.arm_b, -1.0);
  row.stiffness = contact.softness.cwiseInverse();
  const Mover none;
  row.wanted =
      contact.wanted - velocityAt(contact, row.a < 0 ? movers[contact.a] : none, row.b < 0 ? movers[contact.b] : none);
}

template <int kUnknowns>
bool Newton::solveAs(std::vector<Mover>& movers) {
  using Balance = MomentumBalance<kUnknowns>;
  Balance balance(movers, bodies_, rows_);
  typename Balance::Unknowns start(balance.count());
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Mover& mover = movers[bodies_[i]];
    start.template segment<kUnknownsOfABody>(kUnknownsOfABody * static_cast<int>(i)) << mover.linear, mover.angular;
  }
  start += predictedChange(balance, start);
  typename Balance::Unknowns velocities = start;
  if (!iterateCoupled(balance, velocities)) {
    velocities = start;
    if (!solveByLimits(balance, velocities)) {
      return false;
    }
  }
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    Mover& mover = movers[bodies_[i]];
    const auto first = kUnknownsOfABody * static_cast<int>(i);
    mover.linear = velocities.template segment<3>(first);
    mover.angular = velocities.template segment<3>(first + 3);
  }
  for (const BalanceRow& row : rows_) {
    row.contact->impulse = row.impulse;
  }
  return true;
}

template <class Balance>
typename Balance::Unknowns Newton::predictedChange(Balance& balance, const typename Balance::Unknowns& start) {
  // velocities at the start say little about which contacts slip; the impulses of the last step do
  balance.missingMomentum(start);
  std::array<Vector3d, kMostRows> errors;
  for (std::size_t i = 0; i < balance.rows.size(); ++i) {
    BalanceRow& row = balance.rows[i];
    const Vector3d expected = expectedOf(*row.contact, row.missing.template tail<2>().norm());
    errors[i] = row.missing - expected;
    row.missing = expected;
  }
  typename Balance::Unknowns momentum = Balance::Unknowns::Zero(balance.count());
  for (std::size_t i = 0; i < balance.rows.size(); ++i) {
    Balance::addImpulse(balance.rows[i], balance.rows[i].slope() * errors[i], momentum);
  }
  return balance.slope().partialPivLu().solve(momentum);
}

template <class Balance>
bool Newton::iterateCoupled(Balance& balance, typename Balance::Unknowns& velocities) {
  constexpr int kMostIterations = 8;
  constexpr double kProgress = 0.2;
  typename Balance::Unknowns missing = balance.missingMomentum(velocities);
  const double enough = balance.precision();
  double error = balance.errorOf(missing);
  for (int i = 0; i < kMostIterations && error > enough; ++i) {
    velocities += balance.slope().partialPivLu().solve(missing);
    missing = balance.missingMomentum(velocities);
    const double before = error;
    error = balance.errorOf(missing);
    if (i > 0 && error > std::max(kProgress * before, enough)) {
      return false;
    }
  }
  return error <= enough;
}

template <class Balance>
bool Newton::solveByLimits(Balance& balance, typename Balance::Unknowns& velocities) {
  constexpr int kMostRounds = 60;
  constexpr int kFullRounds = 4;  // then limits go half the way, since they may alternate
  Limits limits{};
  for (std::size_t i = 0; i < balance.rows.size(); ++i) {
    const ContactRow& contact = *balance.rows[i].contact;
    limits[i] = contact.coefficient * contact.impulse.x();
  }
  for (int round = 0; round < kMostRounds; ++round) {
    setLimits(limits, balance.rows);
    if (!iterateFixed(balance, velocities)) {
      return false;
    }
    if (followLoads(balance.rows, round < kFullRounds ? 1.0 : 0.5, limits)) {
      return true;
    }
    typename Balance::Unknowns coupled = velocities;
    coupleLimits(balance.rows);
    if (iterateCoupled(balance, coupled)) {
      velocities = coupled;
      return true;
    }
  }
  setLimits(limits, balance.rows);
  return iterateFixed(balance, velocities);
}

bool Newton::followLoads(const std::vector<BalanceRow>& rows, double share, Limits& limits) {
  constexpr double kEqual = 1e-6;  // of the largest limit
  double largest = 0.0;
  double change = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double limit = rows[i].contact->coefficient * rows[i].impulse.x();
    largest = std::max(largest, limit);
    change = std::max(change, std::abs(limit - limits[i]));
    limits[i] += share * (limit - limits[i]);
  }
  return change <= kEqual * largest;
}

template <class Balance>
bool Newton::iterateFixed(Balance& balance, typename Balance::Unknowns& velocities) {
  constexpr int kMostIterations = 100;
  typename Balance::Unknowns missing = balance.missingMomentum(velocities);
  const double enough = balance.precision();
  double error = balance.errorOf(missing);
  for (int i = 0; i < kMostIterations && error > enough; ++i) {
    const typename Balance::Unknowns change = balance.slope().llt().solve(missing);
    velocities += shareOf(balance, change, missing) * change;
    missing = balance.missingMomentum(velocities);
    error = balance.errorOf(missing);
  }
  return error <= enough;
}

template <class Balance>
double Newton::shareOf(const Balance& balance, const typename Balance::Unknowns& change,
                       const typename Balance::Unknowns& missing) {
  constexpr int kMostTrials = 20;
  constexpr double kEnough = 0.1;                     // of the energy's slope at the start
  std::array<Vector3d, kMostRows> speeds;             // of the missing velocities, along the change
  const double slope_at_start = missing.dot(change);  // how fast the energy falls
  double slope_of_bodies = slope_at_start;            // without contacts
  for (std::size_t i = 0; i < balance.rows.size(); ++i) {
    speeds[i] = -Balance::velocityBetween(balance.rows[i], change);
    slope_of_bodies += balance.rows[i].impulse.dot(speeds[i]);
  }
  const double inertia = change.dot(balance.momentumOf(change));
  const auto slopeAt = [&](double share) {
    double slope = slope_of_bodies - share * inertia;
    for (std::size_t i = 0; i < balance.rows.size(); ++i) {
      const BalanceRow& row = balance.rows[i];
      slope -= row.impulseAt(row.missing + share * speeds[i]).dot(speeds[i]);
    }
    return slope;
  };
  double share = 1.0;
  double slope = slopeAt(share);
  if (slope > 0.0) {
    return share;
  }
  // regula falsi, with half the slope at an end that stays (Illinois method)
  double below = 0.0;
  double slope_below = slope_at_start;
  double above = share;
  double slope_above = slope;
  for (int trial = 0; trial < kMostTrials && std::abs(slope) > kEnough * slope_at_start; ++trial) {
    share = below + (above - below) * slope_below / (slope_below - slope_above);
    slope = slopeAt(share);
    if (slope > 0.0) {
      below = share;
      slope_below = slope;
      slope_above *= 0.5;
    } else {
      above = share;
      slope_above = slope;
      slope_below *= 0.5;
    }
  }
  return share;
}

}  // namespace swarmanoid::dynamics3d
