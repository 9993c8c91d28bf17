#include "dynamics3d/solver/contact_solver.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "dynamics3d/contacts/touches.hpp"
#include "dynamics3d/solver/friction.hpp"
#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid::dynamics3d {

using Eigen::Matrix3d;
using Eigen::Vector3d;

void ContactSolver::startStep(dWorldID world, double step, std::size_t bodies) {
  world_ = world;
  step_ = step;
  bodies_ = bodies;
  rows_.clear();
}

void ContactSolver::startMovers() {
  rows_.reserve(kMostTouchesOfABody * bodies_);
  order_.reserve(kMostTouchesOfABody * bodies_);
  sweeps_.reserve(kMostTouchesOfABody * bodies_, bodies_ + 1);
  newton_.reserve();
  movers_.reserve(bodies_ + 1);
  movers_.assign(1, Mover{});
  by_rank_.assign(bodies_, 0);
  bodies_of_.assign(bodies_, 0);
}

std::size_t ContactSolver::moverOf(const Body* body) {
  if (body == nullptr || body->rigid == nullptr) {
    return 0;
  }
  std::size_t& place = by_rank_[static_cast<std::size_t>(body->rank)];
  if (place != 0) {
    return place;
  }
  place = movers_.size();
  Mover& mover = movers_.emplace_back();
  mover.rigid = body->rigid;
  mover.linear = toVector(dBodyGetLinearVel(body->rigid));
  mover.angular = toVector(dBodyGetAngularVel(body->rigid));
  if (body->is_dynamic) {
    dVector3 gravity;
    dWorldGetGravity(world_, gravity);
    const Matrix3d turn = toQuaternion(dBodyGetQuaternion(body->rigid)).toRotationMatrix();
    mover.mass = body->own.mass;
    mover.inverse_mass = 1.0 / mover.mass;
    mover.inertia = turn * body->own.inertia * turn.transpose();
    mover.inverse_inertia = mover.inertia.inverse();
    // as ODE turns a body without torque: implicit, so that it gains no energy
    const Vector3d momentum = mover.inertia * mover.angular;
    const Matrix3d implicit = mover.inertia - step_ * crossMatrix(momentum);
    mover.linear += step_ * (toVector(gravity) + mover.inverse_mass * toVector(dBodyGetForce(body->rigid)));
    mover.angular =
        implicit.inverse() * momentum + step_ * mover.inverse_inertia * toVector(dBodyGetTorque(body->rigid));
    ++bodies_of_[static_cast<std::size_t>(body->island_first)];
  }
  mover.linear_without = mover.linear;
  mover.angular_without = mover.angular;
  return movers_.size() - 1;
}

void ContactSolver::add(const Body& a, const Body* b, const dContact& contact) {
  SWARMANOID_EXPECTS(a.links.empty() && (b == nullptr || b->links.empty()));
  if (rows_.empty()) {
    startMovers();
  }
  const Vector3d point = toVector(contact.geom.pos);
  ContactRow& added = rows_.emplace_back();
  added.key = ContactMemory::keyOf(a, b);
  added.island = static_cast<std::size_t>(a.island_first);
  added.a = moverOf(&a);
  added.b = moverOf(b);
  added.arm_a = point - toVector(dBodyGetPosition(a.rigid));
  added.arm_b = added.b == 0 ? Vector3d::Zero() : Vector3d(point - toVector(dBodyGetPosition(b->rigid)));
  added.coefficient = contact.surface.mu;
  layAxes(a, b, contact, added);
  wantVelocity(contact, added);
  recall(added);
}

void ContactSolver::layAxes(const Body& a, const Body* b, const dContact& contact, ContactRow& row) const {
  constexpr double kUpright = 0.7;
  const Vector3d normal = toVector(contact.geom.normal);
  const bool has_belt = (contact.surface.mode & dContactMotion1) != 0;
  const Vector3d level = std::abs(normal.z()) < kUpright ? Vector3d::UnitZ() : Vector3d::UnitX();
  const Vector3d along = has_belt ? toVector(contact.fdir1) : Vector3d(level.cross(normal).normalized());
  row.axes << normal, along, normal.cross(along);
  row.softness.setConstant(dWorldGetCFM(world_) / step_);
  if (!has_belt && isPushed(a, b, normal)) {
    row.softness.z() = kYield / step_;
  }
  row.wanted.y() = has_belt ? contact.surface.motion1 : 0.0;
}

void ContactSolver::wantVelocity(const dContact& contact, ContactRow& row) const {
  const dSurfaceParameters& surface = contact.surface;
  const double correction = (surface.mode & dContactSoftERP) != 0 ? surface.soft_erp : dWorldGetERP(world_);
  if ((surface.mode & dContactSoftCFM) != 0) {
    row.softness.x() = surface.soft_cfm / step_;
  }
  const double out = correction / step_ * std::max(contact.geom.depth, 0.0) + surface.motionN;
  row.wanted.x() = std::min(out, dWorldGetContactMaxCorrectingVel(world_));
  if ((surface.mode & dContactBounce) != 0) {
    const Vector3d point = toVector(contact.geom.pos);
    const auto before = [&](std::size_t mover) { return velocityAt(movers_[mover].rigid, point); };
    const double approach = -row.axes.col(0).dot(before(row.a) - before(row.b)) + surface.motionN;
    if (approach >= surface.bounce_vel) {
      row.wanted.x() = std::max(row.wanted.x(), surface.bounce * approach + surface.motionN);
    }
  }
}

void ContactSolver::recall(ContactRow& row) {
  if (const ContactForce* before = memory_.recall(row.key, movers_[row.a].rigid, row.arm_a)) {
    row.impulse = step_ * (row.axes.transpose() * before->force);
    row.impulse.x() = std::max(row.impulse.x(), 0.0);
  }
}

void ContactSolver::sortByIslands() {
  islands_.assign(bodies_, IslandRows{});
  for (const ContactRow& row : rows_) {
    ++islands_[row.island].last;
  }
  std::size_t first = 0;
  for (IslandRows& island : islands_) {
    const std::size_t count = island.last;
    island = {first, first};
    first += count;
  }
  order_.resize(rows_.size());
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    order_[islands_[rows_[i].island].last++] = i;
  }
}

void ContactSolver::solve(bool is_settling) {
  if (rows_.empty()) {
    return;
  }
  for (const ContactRow& row : rows_) {
    push(row, row.impulse, movers_[row.a], movers_[row.b]);
  }
  sortByIslands();
  for (std::size_t i = 0; i < islands_.size(); ++i) {
    const IslandRows& island = islands_[i];
    if (island.first == island.last) {
      continue;
    }
    const bool is_small = bodies_of_[i] <= kMostNewtonBodies;
    if (!is_small || !newton_.solve(order_, island, movers_, rows_)) {
      sweeps_.solve(order_, island, is_small || is_settling, movers_, rows_);
    }
  }
  addForces();
  keep();
}

void ContactSolver::addForces() const {
  for (const Mover& mover : movers_) {
    if (mover.mass > 0.0) {
      const Vector3d force = mover.mass / step_ * (mover.linear - mover.linear_without);
      const Vector3d torque = mover.inertia * (mover.angular - mover.angular_without) / step_;
      dBodyAddForce(mover.rigid, force.x(), force.y(), force.z());
      dBodyAddTorque(mover.rigid, torque.x(), torque.y(), torque.z());
    }
  }
}

void ContactSolver::keep() {
  memory_.startPart();
  for (const ContactRow& row : rows_) {
    const Vector3d force = row.impulse / step_;
    memory_.keep(row.key, movers_[row.a].rigid, row.arm_a, {row.axes * force, force.x()});
  }
}

}  // namespace swarmanoid::dynamics3d
