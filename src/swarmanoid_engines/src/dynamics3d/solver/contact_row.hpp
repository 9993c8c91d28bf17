/// Bodies and contacts of the contact solver (contact_solver.hpp). Frame W, SI units.
///
/// A contact has a wanted velocity of body a relative to body b. Its impulse leaves an error of `softness` times the
/// impulse; along the normal it only pushes, and along the tangents Coulomb's law limits its length. Depth correction,
/// softness and bounce are those of ODE's contact joints.
#pragma once

#include <cstdint>
#include <vector>

#include "dynamics3d/ode.hpp"

namespace swarmanoid::dynamics3d {

/// A body with its velocities under the impulses so far.
struct Mover {
  dBodyID rigid = nullptr;
  double mass = 0.0;                                          ///< 0: nothing moves it [kg]
  double inverse_mass = 0.0;                                  ///< 0: nothing moves it [1/kg]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();          ///< about the centre of mass [kg m2]
  Eigen::Matrix3d inverse_inertia = Eigen::Matrix3d::Zero();  ///< [1/(kg m2)]
  Eigen::Vector3d linear = Eigen::Vector3d::Zero();           ///< of the centre of mass [m/s]
  Eigen::Vector3d angular = Eigen::Vector3d::Zero();          ///< [rad/s]
  Eigen::Vector3d linear_without = Eigen::Vector3d::Zero();   ///< at the end of the step without contacts [m/s]
  Eigen::Vector3d angular_without = Eigen::Vector3d::Zero();  ///< [rad/s]
};

/// One contact. Vectors are along its axes: normal out of b, then two tangents.
struct ContactRow {
  std::uint64_t key = 0;   ///< of its bodies (contact_memory.hpp)
  std::size_t island = 0;  ///< rank of the island's first body
  std::size_t a = 0;       ///< index of a mover
  std::size_t b = 0;
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< columns, in W
  Eigen::Vector3d arm_a = Eigen::Vector3d::Zero();     ///< centre of mass to contact, in W [m]
  Eigen::Vector3d arm_b = Eigen::Vector3d::Zero();
  Eigen::Vector3d wanted = Eigen::Vector3d::Zero();    ///< velocity of a relative to b [m/s]
  Eigen::Vector3d softness = Eigen::Vector3d::Zero();  ///< velocity error per impulse [m/s per N s]
  double coefficient = 0.0;                            ///< of friction
  Eigen::Vector3d impulse = Eigen::Vector3d::Zero();   ///< on a [N s]
};

/// Contacts of one island: [first, last) of an order of rows.
struct IslandRows {
  std::size_t first = 0;
  std::size_t last = 0;
};

/// Returns the matrix of the cross product with a vector.
inline Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& v) {
  return (Eigen::Matrix3d() << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0).finished();
}

/// Returns the velocity of a relative to b along the contact's axes [m/s].
inline Eigen::Vector3d velocityAt(const ContactRow& row, const Mover& a, const Mover& b) {
  return row.axes.transpose() * (a.linear + a.angular.cross(row.arm_a) - b.linear - b.angular.cross(row.arm_b));
}

/// Adds an impulse along the contact's axes to the velocities of both bodies. @param impulse on a [N s]
inline void push(const ContactRow& row, const Eigen::Vector3d& impulse, Mover& a, Mover& b) {
  const Eigen::Vector3d on_a = row.axes * impulse;
  a.linear += a.inverse_mass * on_a;
  a.angular += a.inverse_inertia * row.arm_a.cross(on_a);
  b.linear -= b.inverse_mass * on_a;
  b.angular -= b.inverse_inertia * row.arm_b.cross(on_a);
}

}  // namespace swarmanoid::dynamics3d
