#include "dynamics3d/solver/sweeps.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <numeric>

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector4d;

// Small islands converge within a step; in large crowds forces spread over some steps.
constexpr std::size_t kFewestSweeps = 48;
constexpr std::size_t kMostSweeps = 100;
constexpr std::size_t kContactsTimesSweeps = 10000;  // sets the sweeps between these two limits
constexpr std::size_t kThoroughSweeps = 300;
constexpr std::size_t kSweepsOverOthers = 7;  // after each sweep over all contacts
constexpr double kConverged = 1e-4;           // m/s, a thousandth of the speed by gravity in a step of 10 ms
constexpr double kRough = 0.01;               // m/s: faster changes are impacts, which get more sweeps
constexpr double kConvergedThorough = 1e-6;   // m/s

/// Puts the first column, the normal's, last.
Matrix3d tangentsFirst(const Matrix3d& columns) {
  return (Matrix3d() << columns.rightCols<2>(), columns.leftCols<1>()).finished();
}

Vector4d tangentsFirst(const Vector3d& along) { return {along.y(), along.z(), along.x(), 0.0}; }

}  // namespace

void Sweeps::reserve(std::size_t contacts, std::size_t movers) {
  contacts_.reserve(contacts);
  levels_.reserve(contacts);
  firsts_.reserve(contacts + 1);
  sorted_.reserve(contacts);
  visited_.reserve(contacts);
  motions_.resize(std::max(movers, motions_.size()));
  next_level_.resize(motions_.size());
}

void Sweeps::layLever(const Matrix3d& axes, const Mover& mover, const Vector3d& arm, Lever& lever,
                      Matrix3d& velocities) {
  const Matrix3d moment = crossMatrix(arm) * axes;
  const Matrix3d spin = mover.inverse_inertia * moment;
  lever.inverse_mass = mover.inverse_mass;
  lever.turning.topRows<3>() = moment.transpose();
  lever.spin.topRows<3>() = spin;
  velocities += mover.inverse_mass * Matrix3d::Identity() + moment.transpose() * spin;
}

void Sweeps::prepare(const ContactRow& row, const std::vector<Mover>& movers, Contact& contact) {
  const Matrix3d axes = tangentsFirst(row.axes);
  contact.axes.topRows<3>() = axes;
  contact.axes_transposed.topRows<3>() = axes.transpose();
  contact.wanted = tangentsFirst(row.wanted);
  contact.softness = tangentsFirst(row.softness);
  contact.impulse = tangentsFirst(row.impulse);
  contact.coefficient = row.coefficient;
  contact.a.mover = row.a;
  contact.b.mover = row.b;

  Matrix3d velocities = contact.softness.head<3>().asDiagonal();  // along the axes, of a unit of impulse along each
  layLever(axes, movers[row.a], row.arm_a, contact.a, velocities);
  if (row.b != 0) {
    layLever(axes, movers[row.b], row.arm_b, contact.b, velocities);
  }
  const Matrix2d along = velocities.topLeftCorner<2, 2>();
  contact.inverse_normal = 1.0 / velocities(2, 2);
  contact.inverse_along = along.inverse();
  contact.inverse_slip = 1.0 / along.trace();
}

Sweeps::Vector Sweeps::velocityAlong(const Contact& contact) const {
  const Motion& a = motions_[contact.a.mover];
  if (contact.b.mover == 0) {
    return contact.axes_transposed * a.linear.head<3>() + contact.a.turning * a.angular.head<3>();
  }
  const Motion& b = motions_[contact.b.mover];
  const Vector linear = a.linear - b.linear;
  return contact.axes_transposed * linear.head<3>() + contact.a.turning * a.angular.head<3>() -
         contact.b.turning * b.angular.head<3>();
}

void Sweeps::push(const Contact& contact, const Vector& impulse) {
  const Vector on_a = contact.axes * impulse.head<3>();
  Motion& a = motions_[contact.a.mover];
  a.linear += contact.a.inverse_mass * on_a;
  a.angular += contact.a.spin * impulse.head<3>();
  if (contact.b.mover != 0) {
    Motion& b = motions_[contact.b.mover];
    b.linear -= contact.b.inverse_mass * on_a;
    b.angular -= contact.b.spin * impulse.head<3>();
  }
}

/// @return largest change of the impulse as a velocity [m/s]
double Sweeps::correct(Contact& contact) {
  const Vector before = contact.impulse;
  const Vector missing = contact.wanted - velocityAlong(contact) - contact.softness.cwiseProduct(before);
  const double normal = std::max(before.z() + contact.inverse_normal * missing.z(), 0.0);
  const double limit = contact.coefficient * normal;
  Vector2d along = before.head<2>() + contact.inverse_along * missing.head<2>();
  if (along.squaredNorm() > limit * limit) {
    // Friction of a slipping contact opposes the slip. The full effective mass would turn it away from the slip, since
    // it differs between directions.
    along = before.head<2>() + contact.inverse_slip * missing.head<2>();
    const double size = along.norm();
    along *= size > limit ? limit / size : 1.0;
  }
  contact.impulse = {along.x(), along.y(), normal, 0.0};
  const Vector change = contact.impulse - before;
  push(contact, change);
  contact.change = change.cwiseAbs().maxCoeff() / contact.inverse_normal;
  return contact.change;
}

void Sweeps::startMotions(const std::vector<Mover>& movers) {
  for (const Contact& contact : contacts_) {
    for (const std::size_t mover : {contact.a.mover, contact.b.mover}) {
      motions_[mover].linear.head<3>() = movers[mover].linear;
      motions_[mover].angular.head<3>() = movers[mover].angular;
    }
  }
}

void Sweeps::returnMotions(std::vector<Mover>& movers) const {
  for (const Contact& contact : contacts_) {
    for (const std::size_t mover : {contact.a.mover, contact.b.mover}) {
      movers[mover].linear = motions_[mover].linear.head<3>();
      movers[mover].angular = motions_[mover].angular.head<3>();
    }
  }
}

void Sweeps::sortByLevel(const std::vector<std::size_t>& order, const IslandRows& island,
                         const std::vector<ContactRow>& rows) {
  for (std::size_t i = island.first; i < island.last; ++i) {
    next_level_[rows[order[i]].a] = 0;
    next_level_[rows[order[i]].b] = 0;
  }
  levels_.clear();
  firsts_.assign(1, 0);  // of each level, and the end
  for (std::size_t i = island.first; i < island.last; ++i) {
    const ContactRow& row = rows[order[i]];
    const std::size_t of_b = row.b == 0 ? 0 : next_level_[row.b];
    const std::size_t level = std::max(next_level_[row.a], of_b);
    next_level_[row.a] = level + 1;
    next_level_[row.b] = level + 1;
    levels_.push_back(level);
    firsts_.resize(std::max(firsts_.size(), level + 2), 0);
    ++firsts_[level + 1];
  }
  std::partial_sum(firsts_.begin(), firsts_.end(), firsts_.begin());
  sorted_.resize(levels_.size());
  for (std::size_t i = 0; i < levels_.size(); ++i) {
    sorted_[firsts_[levels_[i]]++] = order[island.first + i];
  }
}

double Sweeps::sweep() {
  double change = 0.0;  // m/s
  for (Contact* contact : visited_) {
    change = std::max(change, correct(*contact));
  }
  std::for_each(visited_.rbegin(), visited_.rend(),
                [&](Contact* contact) { change = std::max(change, correct(*contact)); });
  return change;
}

void Sweeps::repeat(std::size_t most, double converged) {
  std::size_t sweeps = 0;
  double change = 0.0;  // m/s
  const auto mayGoOn = [&](double largest) {
    return largest > converged && (sweeps < most || (largest > kRough && sweeps < kThoroughSweeps));
  };
  do {
    visited_.clear();
    for (Contact& contact : contacts_) {
      visited_.push_back(&contact);
    }
    change = sweep();
    ++sweeps;
    const auto is_quiet = [&](const Contact* contact) { return contact->change <= converged; };
    visited_.erase(std::remove_if(visited_.begin(), visited_.end(), is_quiet), visited_.end());
    double of_others = change;
    for (std::size_t i = 0; i < kSweepsOverOthers && mayGoOn(of_others); ++i) {
      of_others = sweep();
      ++sweeps;
    }
  } while (mayGoOn(change));
}

void Sweeps::solve(const std::vector<std::size_t>& order, const IslandRows& island, bool is_thorough,
                   std::vector<Mover>& movers, std::vector<ContactRow>& rows) {
  sortByLevel(order, island, rows);
  contacts_.clear();
  for (const std::size_t row : sorted_) {
    prepare(rows[row], movers, contacts_.emplace_back());
  }
  startMotions(movers);
  if (is_thorough) {
    repeat(kThoroughSweeps, kConvergedThorough);
  } else {
    const std::size_t contacts = std::max<std::size_t>(contacts_.size(), 1);
    repeat(std::clamp(kContactsTimesSweeps / contacts, kFewestSweeps, kMostSweeps), kConverged);
  }
  returnMotions(movers);
  for (std::size_t i = 0; i < sorted_.size(); ++i) {
    const Vector& impulse = contacts_[i].impulse;
    rows[sorted_[i]].impulse = {impulse.z(), impulse.x(), impulse.y()};
  }
}

}  // namespace swarmanoid::dynamics3d
