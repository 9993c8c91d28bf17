#include "dynamics3d/crowd_solver.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics3d/friction.hpp"
#include "dynamics3d/touches.hpp"
#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

// Each sweep visits every contact twice, forwards and backwards. Small crowds converge within a step; in large crowds
// forces spread over some steps.
constexpr std::size_t kFewestSweeps = 20;
constexpr std::size_t kMostSweeps = 100;
constexpr std::size_t kContactsTimesSweeps = 10000;  // sets the sweeps between these two limits
constexpr std::size_t kSettlingSweeps = 300;
constexpr double kConverged = 1e-6;  // m/s

Matrix3d crossMatrix(const Vector3d& v) {
  return (Matrix3d() << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0).finished();
}

}  // namespace

void CrowdSolver::startStep(dWorldID world, double step, std::size_t bodies) {
  world_ = world;
  step_ = step;
  bodies_ = bodies;
  contacts_.clear();
}

void CrowdSolver::startMovers() {
  contacts_.reserve(kMostTouchesOfABody * bodies_);
  order_.reserve(kMostTouchesOfABody * bodies_);
  movers_.reserve(bodies_ + 1);
  movers_.assign(1, Mover{});
  by_rank_.assign(bodies_, 0);
}

std::size_t CrowdSolver::moverOf(const Body* body) {
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
    mover.inverse_mass = 1.0 / body->own.mass;
    mover.inverse_inertia = (turn * body->own.inertia * turn.transpose()).inverse();
    mover.linear += step_ * (toVector(gravity) + mover.inverse_mass * toVector(dBodyGetForce(body->rigid)));
    mover.angular += step_ * mover.inverse_inertia * toVector(dBodyGetTorque(body->rigid));
  }
  mover.linear_without = mover.linear;
  mover.angular_without = mover.angular;
  return movers_.size() - 1;
}

void CrowdSolver::add(const Body& a, const Body* b, const dContact& contact) {
  SWARMANOID_EXPECTS(a.links.empty() && (b == nullptr || b->links.empty()));
  if (contacts_.empty()) {
    startMovers();
  }
  const Vector3d point = toVector(contact.geom.pos);
  Contact& added = contacts_.emplace_back();
  added.key = ContactMemory::keyOf(a, b);
  added.island = static_cast<std::size_t>(a.island_first);
  added.a = moverOf(&a);
  added.b = moverOf(b);
  added.arm_a = point - toVector(dBodyGetPosition(a.rigid));
  added.arm_b = added.b == 0 ? Vector3d::Zero() : Vector3d(point - toVector(dBodyGetPosition(b->rigid)));
  added.coefficient = contact.surface.mu;
  layAxes(a, b, contact, added);
  wantVelocity(contact, added);
  weigh(added);
  recall(added);
}

void CrowdSolver::layAxes(const Body& a, const Body* b, const dContact& contact, Contact& laid) const {
  constexpr double kUpright = 0.7;
  const Vector3d normal = toVector(contact.geom.normal);
  const bool has_belt = (contact.surface.mode & dContactMotion1) != 0;
  const Vector3d level = std::abs(normal.z()) < kUpright ? Vector3d::UnitZ() : Vector3d::UnitX();
  const Vector3d along = has_belt ? toVector(contact.fdir1) : Vector3d(level.cross(normal).normalized());
  laid.axes << normal, along, normal.cross(along);
  laid.softness.setConstant(dWorldGetCFM(world_) / step_);
  if (!has_belt && isPushed(a, b, normal)) {
    laid.softness.z() = kYield / step_;
  }
  laid.wanted.y() = has_belt ? contact.surface.motion1 : 0.0;
}

void CrowdSolver::wantVelocity(const dContact& ode, Contact& contact) const {
  const dSurfaceParameters& surface = ode.surface;
  const double correction = (surface.mode & dContactSoftERP) != 0 ? surface.soft_erp : dWorldGetERP(world_);
  if ((surface.mode & dContactSoftCFM) != 0) {
    contact.softness.x() = surface.soft_cfm / step_;
  }
  const double out = correction / step_ * std::max(ode.geom.depth, 0.0) + surface.motionN;
  contact.wanted.x() = std::min(out, dWorldGetContactMaxCorrectingVel(world_));
  if ((surface.mode & dContactBounce) != 0) {
    const Vector3d point = toVector(ode.geom.pos);
    const auto before = [&](std::size_t mover) { return dynamics3d::velocityAt(movers_[mover].rigid, point); };
    const double approach = -contact.axes.col(0).dot(before(contact.a) - before(contact.b)) + surface.motionN;
    if (approach >= surface.bounce_vel) {
      contact.wanted.x() = std::max(contact.wanted.x(), surface.bounce * approach + surface.motionN);
    }
  }
}

void CrowdSolver::weigh(Contact& contact) const {
  Matrix3d velocities = contact.softness.asDiagonal();  // along the axes, of a unit of impulse along each
  const auto addMover = [&](const Mover& mover, const Vector3d& arm) {
    const Matrix3d turning = crossMatrix(arm).transpose() * contact.axes;  // -(arm x axis)
    velocities += mover.inverse_mass * Matrix3d::Identity() + turning.transpose() * mover.inverse_inertia * turning;
  };
  addMover(movers_[contact.a], contact.arm_a);
  addMover(movers_[contact.b], contact.arm_b);
  contact.inverse_normal = 1.0 / velocities(0, 0);
  const Matrix2d along = velocities.bottomRightCorner<2, 2>();
  contact.inverse_along = along.inverse();
  contact.inverse_slip = 1.0 / along.trace();
}

void CrowdSolver::recall(Contact& contact) {
  if (const ContactForce* before = memory_.recall(contact.key, movers_[contact.a].rigid, contact.arm_a)) {
    contact.impulse = step_ * (contact.axes.transpose() * before->force);
    contact.impulse.x() = std::max(contact.impulse.x(), 0.0);
  }
}

Vector3d CrowdSolver::velocityAt(const Contact& contact) const {
  const Mover& a = movers_[contact.a];
  const Mover& b = movers_[contact.b];
  return contact.axes.transpose() *
         (a.linear + a.angular.cross(contact.arm_a) - b.linear - b.angular.cross(contact.arm_b));
}

void CrowdSolver::push(const Contact& contact, const Vector3d& impulse) {
  const Vector3d on_a = contact.axes * impulse;
  Mover& a = movers_[contact.a];
  a.linear += a.inverse_mass * on_a;
  a.angular += a.inverse_inertia * contact.arm_a.cross(on_a);
  Mover& b = movers_[contact.b];
  b.linear -= b.inverse_mass * on_a;
  b.angular -= b.inverse_inertia * contact.arm_b.cross(on_a);
}

double CrowdSolver::correct(Contact& contact) {
  const Vector3d before = contact.impulse;
  const Vector3d missing = contact.wanted - velocityAt(contact) - contact.softness.cwiseProduct(before);
  contact.impulse.x() = std::max(before.x() + contact.inverse_normal * missing.x(), 0.0);
  const double limit = contact.coefficient * contact.impulse.x();
  Vector2d along = before.tail<2>() + contact.inverse_along * missing.tail<2>();
  if (along.squaredNorm() > limit * limit) {
    // Friction of a slipping contact opposes the slip. The full effective mass would turn it away from the slip, since
    // it differs between directions.
    along = before.tail<2>() + contact.inverse_slip * missing.tail<2>();
    const double size = along.norm();
    along *= size > limit ? limit / size : 1.0;
  }
  contact.impulse.tail<2>() = along;
  const Vector3d change = contact.impulse - before;
  push(contact, change);
  return change.cwiseAbs().maxCoeff() / contact.inverse_normal;
}

double CrowdSolver::sweep(const Range& range) {
  double most = 0.0;
  for (std::size_t i = range.first; i < range.last; ++i) {
    most = std::max(most, correct(contacts_[order_[i]]));
  }
  for (std::size_t i = range.last; i > range.first; --i) {
    most = std::max(most, correct(contacts_[order_[i - 1]]));
  }
  return most;
}

void CrowdSolver::sortByIslands() {
  islands_.assign(bodies_, Range{});
  for (const Contact& contact : contacts_) {
    ++islands_[contact.island].last;
  }
  std::size_t first = 0;
  for (Range& range : islands_) {
    const std::size_t count = range.last;
    range = {first, first};
    first += count;
  }
  order_.resize(contacts_.size());
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    order_[islands_[contacts_[i].island].last++] = i;
  }
}

void CrowdSolver::solve(bool is_settling) {
  if (contacts_.empty()) {
    return;
  }
  for (const Contact& contact : contacts_) {
    push(contact, contact.impulse);
  }
  sortByIslands();
  for (const Range& range : islands_) {
    const std::size_t contacts = std::max<std::size_t>(range.last - range.first, 1);
    const std::size_t most =
        is_settling ? kSettlingSweeps : std::clamp(kContactsTimesSweeps / contacts, kFewestSweeps, kMostSweeps);
    for (std::size_t i = 0; i < most && sweep(range) > kConverged; ++i) {
    }
  }
  for (const Mover& mover : movers_) {
    if (mover.inverse_mass > 0.0) {
      const Vector3d force = (mover.linear - mover.linear_without) / (step_ * mover.inverse_mass);
      const Vector3d torque = mover.inverse_inertia.inverse() * (mover.angular - mover.angular_without) / step_;
      dBodyAddForce(mover.rigid, force.x(), force.y(), force.z());
      dBodyAddTorque(mover.rigid, torque.x(), torque.y(), torque.z());
    }
  }
  keep();
}

void CrowdSolver::keep() {
  memory_.startPart();
  for (const Contact& contact : contacts_) {
    const Vector3d force = contact.impulse / step_;
    memory_.keep(contact.key, movers_[contact.a].rigid, contact.arm_a, {contact.axes * force, force.x()});
  }
}

}  // namespace swarmanoid::dynamics3d
