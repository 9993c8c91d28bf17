/// The balance of momentum of an island in a step, as equations for the velocities of its bodies at the end
/// (newton.hpp).
///
/// A contact that misses a velocity gives an impulse of the missing velocity times its stiffness, as far as it may push
/// and rub. Friction of a contact that slips is as large as its limit, along the slip that the softness leaves. The
/// limit is that of the load, or fixed; with fixed limits the solution is the minimum of a convex energy.
///
/// Frame W, SI units. Threads: one at a time for each object.
#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "dynamics3d/solver/contact_row.hpp"

namespace swarmanoid::dynamics3d {

/// Linear velocity of the centre of mass, then angular velocity, in W.
constexpr int kUnknownsOfABody = 6;
/// Limit of the movable bodies in an island: with more, Newton's method takes longer than sweeps.
constexpr std::size_t kMostNewtonBodies = 4;

/// A contact, with the velocities of its bodies as unknowns. Vectors are along the contact's axes.
struct BalanceRow {
  using Momenta = Eigen::Matrix<double, kUnknownsOfABody, 3>;

  ContactRow* contact = nullptr;
  int a = -1;  ///< index of the first of its unknowns; -1: immovable
  int b = -1;
  Momenta on_a = Momenta::Zero();                       ///< momentum by a unit of impulse along each axis, in columns
  Momenta on_b = Momenta::Zero();                       ///< the same of b
  Eigen::Vector3d stiffness = Eigen::Vector3d::Zero();  ///< impulse per missing velocity [N s per m/s]
  Eigen::Vector3d wanted = Eigen::Vector3d::Zero();     ///< beyond the velocity of immovable bodies [m/s]
  double limit = -1.0;                                  ///< of friction [N s]; below 0: by the load
  Eigen::Vector3d missing = Eigen::Vector3d::Zero();    ///< velocity [m/s]
  Eigen::Vector3d impulse = Eigen::Vector3d::Zero();    ///< [N s]

  /// Returns the impulse at a missing velocity.
  Eigen::Vector3d impulseAt(const Eigen::Vector3d& missing_velocity) const;
  /// Returns the derivative of the impulse by the missing velocity.
  Eigen::Matrix3d slope() const;
};

/// @tparam kUnknowns their number, or Eigen::Dynamic for up to kMostNewtonBodies bodies
template <int kUnknowns>
class MomentumBalance {
  static constexpr int kMost =
      kUnknowns == Eigen::Dynamic ? kUnknownsOfABody * static_cast<int>(kMostNewtonBodies) : kUnknowns;

 public:
  using Unknowns = Eigen::Matrix<double, kUnknowns, 1, 0, kMost, 1>;
  using Square = Eigen::Matrix<double, kUnknowns, kUnknowns, 0, kMost, kMost>;

  /// @param bodies indices of movers, in the order of the unknowns
  MomentumBalance(const std::vector<Mover>& movers, const std::vector<std::size_t>& bodies,
                  std::vector<BalanceRow>& island_rows)
      : rows(island_rows), movers_(movers), bodies_(bodies) {}

  std::vector<BalanceRow>& rows;

  int count() const { return kUnknownsOfABody * static_cast<int>(bodies_.size()); }

  /// Sets the missing velocities and impulses of all rows. @return the momentum that is missing [N s, N m s]
  Unknowns missingMomentum(const Unknowns& velocities) {
    Unknowns missing = momentumOf(withoutContacts() - velocities);
    for (BalanceRow& row : rows) {
      row.missing = row.wanted - velocityBetween(row, velocities);
      row.impulse = row.impulseAt(row.missing);
      addImpulse(row, row.impulse, missing);
    }
    return missing;
  }

  /// Returns a missing momentum as a velocity [m/s].
  double errorOf(const Unknowns& missing) const {
    double sum = 0.0;  // m2/s2
    visitBodies([&](const Mover& mover, int first) {
      const Eigen::Vector3d torque = missing.template segment<3>(first + 3);
      sum += mover.inverse_mass * mover.inverse_mass * missing.template segment<3>(first).squaredNorm() +
             mover.inverse_mass * torque.dot(mover.inverse_inertia * torque);
    });
    return std::sqrt(sum);
  }

  /// Returns the error at which a solution is accepted [m/s]: larger for light bodies, where rounding allows no less.
  double precision() const {
    constexpr double kEnough = 1e-9;
    constexpr double kRounding = 1e-15;
    double fastest = 0.0;
    double stiffest = 0.0;
    double lightest = 0.0;  // 1/kg
    for (const BalanceRow& row : rows) {
      fastest = std::max(fastest, row.missing.cwiseAbs().maxCoeff() + row.wanted.cwiseAbs().maxCoeff());
      stiffest = std::max(stiffest, row.stiffness.maxCoeff());
    }
    visitBodies([&](const Mover& mover, int /*first*/) { lightest = std::max(lightest, mover.inverse_mass); });
    return std::max(kEnough, kRounding * fastest * stiffest * lightest);
  }

  /// Returns the derivative of minus the missing momentum, at the missing velocities of the rows.
  Square slope() const {
    Square slope = Square::Zero(count(), count());
    visitBodies([&](const Mover& mover, int first) {
      slope.template block<3, 3>(first, first).diagonal().setConstant(mover.mass);
      slope.template block<3, 3>(first + 3, first + 3) = mover.inertia;
    });
    for (const BalanceRow& row : rows) {
      const Eigen::Matrix3d own = row.slope();
      if (own.isZero(0.0)) {
        continue;
      }
      const auto add = [&](int first, const BalanceRow::Momenta& by, int second, const BalanceRow::Momenta& of) {
        if (first >= 0 && second >= 0) {
          const BalanceRow::Momenta scaled = by.lazyProduct(own);
          slope.template block<kUnknownsOfABody, kUnknownsOfABody>(first, second) += scaled.lazyProduct(of.transpose());
        }
      };
      add(row.a, row.on_a, row.a, row.on_a);
      add(row.b, row.on_b, row.b, row.on_b);
      add(row.a, row.on_a, row.b, row.on_b);
      add(row.b, row.on_b, row.a, row.on_a);
    }
    return slope;
  }

  Unknowns momentumOf(const Unknowns& velocities) const {
    Unknowns momentum(velocities.size());
    visitBodies([&](const Mover& mover, int first) {
      momentum.template segment<3>(first) = mover.mass * velocities.template segment<3>(first);
      momentum.template segment<3>(first + 3) = mover.inertia * velocities.template segment<3>(first + 3);
    });
    return momentum;
  }

  /// Returns the velocity of a relative to b along the contact's axes [m/s]. Immovable bodies count as at rest.
  static Eigen::Vector3d velocityBetween(const BalanceRow& row, const Unknowns& velocities) {
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
    if (row.a >= 0) {
      velocity.noalias() += row.on_a.transpose() * velocities.template segment<kUnknownsOfABody>(row.a);
    }
    if (row.b >= 0) {
      velocity.noalias() += row.on_b.transpose() * velocities.template segment<kUnknownsOfABody>(row.b);
    }
    return velocity;
  }

  /// Adds an impulse of a contact to the momenta of its bodies.
  static void addImpulse(const BalanceRow& row, const Eigen::Vector3d& impulse, Unknowns& momentum) {
    if (row.a >= 0) {
      momentum.template segment<kUnknownsOfABody>(row.a).noalias() += row.on_a * impulse;
    }
    if (row.b >= 0) {
      momentum.template segment<kUnknownsOfABody>(row.b).noalias() += row.on_b * impulse;
    }
  }

 private:
  /// Calls visit(mover, index of its first unknown) for each body.
  template <class Visit>
  void visitBodies(Visit visit) const {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      visit(movers_[bodies_[i]], kUnknownsOfABody * static_cast<int>(i));
    }
  }

  Unknowns withoutContacts() const {
    Unknowns velocities(count());
    visitBodies([&](const Mover& mover, int first) {
      velocities.template segment<kUnknownsOfABody>(first) << mover.linear_without, mover.angular_without;
    });
    return velocities;
  }

  const std::vector<Mover>& movers_;
  const std::vector<std::size_t>& bodies_;
};

}  // namespace swarmanoid::dynamics3d
