#include "dynamics3d/friction.hpp"

#include <algorithm>
#include <cmath>

#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;

constexpr double kSlips = 1e-3;  // m/s: what slips less is held

/// The part of a vector along a surface.
Vector3d alongSurface(const Vector3d& vector, const Vector3d& normal) { return vector - normal.dot(vector) * normal; }

/// Some direction along a surface that turns with the body.
Vector3d ownAxis(dBodyID rigid, const Vector3d& normal) {
  constexpr double kLeastAcross = 0.5;
  const Eigen::Quaterniond turn = toQuaternion(dBodyGetQuaternion(rigid));
  const Vector3d axis = alongSurface(turn * Vector3d::UnitX(), normal);
  return (axis.norm() > kLeastAcross ? axis : alongSurface(turn * Vector3d::UnitY(), normal)).normalized();
}

void layAlong(const Vector3d& axis, const Vector3d& belt, dContact& contact) {
  const Vector3d across = toVector(contact.geom.normal).cross(axis);
  Eigen::Map<Vector3d>(contact.fdir1) = axis;
  contact.surface.mode |= dContactFDir1 | dContactMotion1 | dContactMotion2;
  contact.surface.motion1 = belt.dot(axis);
  contact.surface.motion2 = belt.dot(across);
}

/// Of a point of a body that was so far from its centre of mass before the step.
Vector3d velocityOf(dBodyID rigid, const Vector3d& arm) {
  if (rigid == nullptr) {
    return Vector3d::Zero();
  }
  return toVector(dBodyGetLinearVel(rigid)) + toVector(dBodyGetAngularVel(rigid)).cross(arm);
}

Vector3d armTo(const Vector3d& point, dBodyID rigid) {
  return rigid == nullptr ? Vector3d::Zero() : Vector3d(point - toVector(dBodyGetPosition(rigid)));
}

/// Of the lighter of two bodies that forces move [kg].
double lighterMass(const Body& a, const Body* b) {
  if (b == nullptr || !b->is_dynamic) {
    return a.model->mass;
  }
  return a.is_dynamic ? std::min(a.model->mass, b->model->mass) : b->model->mass;
}

/// The larger part of friction along its two axes.
double mostAlongAxes(const Vector3d& friction, const Vector3d& axis, const Vector3d& normal) {
  return std::max(std::abs(friction.dot(axis)), std::abs(friction.dot(normal.cross(axis))));
}

}  // namespace

void Friction::startStep(double step, double gravity) {
  step_ = step;
  gravity_ = gravity;
  next_ = 0;
  is_again_ = false;
}

void Friction::startAgain() {
  next_ = 0;
  is_again_ = true;
}

void Friction::watch(dJointID joint) {
  Rubbing& rubbing = rubbings_[next_ - 1];
  if (!rubbing.keeps_axis) {
    dJointSetFeedback(joint, &rubbing.feedback);
  }
}

Friction::Rubbing& Friction::next() {
  constexpr std::size_t kFirst = 1024;
  if (next_ == rubbings_.size()) {
    rubbings_.resize(std::max(kFirst, 2 * rubbings_.size()));  // by so many that it hardly happens again
  }
  return rubbings_[next_++];
}

void Friction::lay(const Body& a, dBodyID rigid_a, const Body* b, dBodyID rigid_b, dContact& contact) {
  SWARMANOID_EXPECTS(toVector(contact.geom.normal) != Vector3d::Zero() && contact.surface.mu >= 0.0);
  Rubbing& rubbing = next();
  const bool has_belt = (contact.surface.mode & dContactMotion1) != 0;
  const Vector3d point = toVector(contact.geom.pos);
  rubbing.rigid_a = rigid_a;
  rubbing.rigid_b = rigid_b;
  rubbing.normal = toVector(contact.geom.normal);
  rubbing.arm_a = armTo(point, rigid_a);
  rubbing.arm_b = armTo(point, rigid_b);
  rubbing.belt = has_belt ? Vector3d(contact.surface.motion1 * toVector(contact.fdir1)) : Vector3d::Zero();
  rubbing.coefficient = contact.surface.mu;
  rubbing.mass = lighterMass(a, b);
  rubbing.is_known = rubbing.is_known && is_again_;
  if (!rubbing.is_known) {
    guess(a, b, contact, rubbing);
  }
  layAlong(rubbing.axis, rubbing.belt, contact);
  contact.surface.mode |= dContactSlip2;
  // less than the world's own softness would leave forces undetermined where several contacts share a load
  contact.surface.slip2 = std::max(rubbing.slip_per_force, dWorldGetCFM(dBodyGetWorld(rigid_a)));
}

void Friction::guess(const Body& a, const Body* b, const dContact& contact, Rubbing& rubbing) const {
  constexpr double kStill = 1e-9;  // m/s
  const bool has_belt = (contact.surface.mode & dContactMotion1) != 0;
  const Vector3d slip = slipOf(rubbing);
  const double speed = slip.norm();
  const double holds = has_belt ? kSlips + changeOfBelt(rubbing) : kSlips;
  // a treel that begins to slip finds its direction in the steps that follow; in a crowd some treel always begins to
  rubbing.keeps_axis = has_belt || speed > holds;
  rubbing.slip_per_force = 0.0;
  if (speed > holds) {
    rubbing.axis = slip / speed;
    if (rubbing.coefficient > 0.0) {
      rubbing.slip_per_force = speed / (rubbing.coefficient * usualLoad(rubbing));
    }
    return;
  }
  const Vector3d pull = pullOf(&a, rubbing.rigid_a) - pullOf(b, rubbing.rigid_b);
  const Vector3d expected = slip + alongSurface(step_ * pull, rubbing.normal);
  if (expected.norm() > (has_belt ? holds : kStill)) {
    rubbing.axis = expected.normalized();
  } else {
    rubbing.axis = has_belt ? toVector(contact.fdir1) : ownAxis(rubbing.rigid_a, rubbing.normal);
  }
}

double Friction::changeOfBelt(const Rubbing& rubbing) const {
  constexpr double kSteps = 1.5;  // a treel that holds has the direction of the middle of the last step
  const double turn_rate = rubbing.normal.dot(toVector(dBodyGetAngularVel(rubbing.rigid_a)));
  return step_ * kSteps * std::abs(turn_rate) * rubbing.belt.norm();
}

double Friction::usualLoad(const Rubbing& rubbing) const {
  constexpr double kContacts = 4.0;  // that share a body's weight
  constexpr double kLeast = 1.0;     // m/s2, where there is no gravity
  return rubbing.mass * std::max(gravity_, kLeast) / kContacts;
}

Vector3d Friction::slipOf(const Rubbing& rubbing) {
  return alongSurface(
      velocityOf(rubbing.rigid_a, rubbing.arm_a) - velocityOf(rubbing.rigid_b, rubbing.arm_b) - rubbing.belt,
      rubbing.normal);
}

Vector3d Friction::pullOf(const Body* body, dBodyID rigid) const {
  if (body == nullptr || rigid == nullptr || !body->is_dynamic) {
    return Vector3d::Zero();
  }
  return (toVector(dBodyGetForce(rigid)) + body->pull) / body->model->mass - gravity_ * Vector3d::UnitZ();
}

bool Friction::isCoulombs() {
  bool are_all = true;
  for (std::size_t i = 0; i < next_; ++i) {
    are_all = isCoulombs(rubbings_[i]) && are_all;
  }
  return are_all;
}

bool Friction::isCoulombs(Rubbing& rubbing) {
  constexpr double kAstray = 0.01;      // of the force
  constexpr double kNoticeable = 0.02;  // m/s2, of the lighter body
  if (rubbing.keeps_axis) {
    return true;
  }
  const Vector3d force = toVector(rubbing.feedback.f1);
  const double load = rubbing.normal.dot(force);
  const Vector3d friction = force - load * rubbing.normal;
  const double size = friction.norm();
  const double noticeable = kNoticeable * rubbing.mass;
  const double limit = rubbing.coefficient * load;
  if (limit < noticeable || size < noticeable) {
    return true;
  }
  const Vector3d slip = slipOf(rubbing);
  const double speed = slip.norm();
  const bool slips = speed > kSlips;
  // the friction that ODE allows along the axis, from the loads without friction
  const double allowed = slips ? std::abs(friction.dot(rubbing.axis))
                               : std::max(limit, mostAlongAxes(friction, rubbing.axis, rubbing.normal));
  const double astray = slips ? (friction + allowed / speed * slip).norm() : size - allowed;
  if (astray < kAstray * size || astray < noticeable) {
    return true;
  }
  rubbing.is_known = true;
  rubbing.axis = slips ? Vector3d(slip / speed) : Vector3d(-friction / size);
  rubbing.slip_per_force = slips ? speed / limit : 0.0;
  return false;
}

}  // namespace swarmanoid::dynamics3d
