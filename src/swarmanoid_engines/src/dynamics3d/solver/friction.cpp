#include "dynamics3d/solver/friction.hpp"

#include <algorithm>
#include <cmath>

#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;

constexpr double kSlips = 1e-3;       // m/s: contacts that slip less are held
constexpr double kNoticeable = 0.02;  // m/s2, of the lighter body: smaller changes of forces do not matter

/// Component of a vector along a surface.
Vector3d alongSurface(const Vector3d& vector, const Vector3d& normal) { return vector - normal.dot(vector) * normal; }

/// A direction along a surface, fixed to the body.
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

/// Velocity of a point of a body. @param arm from the centre of mass to the point, before the step
Vector3d velocityOf(dBodyID rigid, const Vector3d& arm) {
  if (rigid == nullptr) {
    return Vector3d::Zero();
  }
  return toVector(dBodyGetLinearVel(rigid)) + toVector(dBodyGetAngularVel(rigid)).cross(arm);
}

Vector3d armTo(const Vector3d& point, dBodyID rigid) {
  return rigid == nullptr ? Vector3d::Zero() : Vector3d(point - toVector(dBodyGetPosition(rigid)));
}

/// Mass of the lighter dynamic body [kg].
double lighterMass(const Body& a, const Body* b) {
  if (b == nullptr || !b->is_dynamic) {
    return a.model->mass;
  }
  return a.is_dynamic ? std::min(a.model->mass, b->model->mass) : b->model->mass;
}

bool isUpright(const Vector3d& normal) {
  constexpr double kUpright = 0.2;
  return std::abs(normal.z()) < kUpright;
}

bool isDriven(const Body& body) { return body.is_dynamic && body.model->wheels.has_value(); }

}  // namespace

bool isPushed(const Body& a, const Body* b, const Vector3d& normal) {
  return isUpright(normal) && b != nullptr && a.is_dynamic && b->is_dynamic && isDriven(a) != isDriven(*b);
}

void Friction::startStep(double step, double gravity, std::size_t contacts, bool uses_memory) {
  step_ = step;
  uses_memory_ = uses_memory;
  gravity_ = gravity;
  is_again_ = false;
  contacts_ = contacts;
  are_rubbings_reset_ = false;
}

void Friction::resetRubbings() {
  constexpr std::size_t kFirst = 1024;
  if (contacts_ > rubbings_.size()) {
    rubbings_.resize(std::max({kFirst, contacts_, 2 * rubbings_.size()}));  // by so many that it hardly happens again
  }
  for (std::size_t i = 0; i < contacts_; ++i) {
    rubbings_[i].a = nullptr;
  }
  are_rubbings_reset_ = true;
}

void Friction::watch(std::size_t number, dJointID joint) { dJointSetFeedback(joint, &rubbings_[number].feedback); }

void Friction::lay(std::size_t number, const Body& a, dBodyID rigid_a, const Body* b, dBodyID rigid_b,
                   dContact& contact) {
  SWARMANOID_EXPECTS(toVector(contact.geom.normal) != Vector3d::Zero() && contact.surface.mu >= 0.0);
  SWARMANOID_EXPECTS(number < contacts_);
  if (!are_rubbings_reset_) {
    resetRubbings();
  }
  Rubbing& rubbing = rubbings_[number];
  const bool has_belt = (contact.surface.mode & dContactMotion1) != 0;
  const Vector3d point = toVector(contact.geom.pos);
  rubbing.a = &a;
  rubbing.key = ContactMemory::keyOf(a, b);
  rubbing.rigid_a = rigid_a;
  rubbing.rigid_b = rigid_b;
  rubbing.normal = toVector(contact.geom.normal);
  rubbing.arm_a = armTo(point, rigid_a);
  rubbing.arm_b = armTo(point, rigid_b);
  rubbing.belt = has_belt ? Vector3d(contact.surface.motion1 * toVector(contact.fdir1)) : Vector3d::Zero();
  rubbing.coefficient = contact.surface.mu;
  rubbing.mass = lighterMass(a, b);
  rubbing.is_known = rubbing.is_known && is_again_;
  if (!is_again_) {
    rubbing.limit = uses_memory_ ? recall(rubbing) : -1.0;
  }
  if (!rubbing.is_known) {
    guess(a, b, contact, rubbing);
  }
  if (rubbing.limit >= 0.0) {
    contact.surface.mode &= ~dContactApprox1;
    contact.surface.mu = rubbing.limit;
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
  if (!has_belt && isPushed(a, b, rubbing.normal)) {
    rubbing.keeps_axis = true;
    rubbing.holding = kSlips;
    rubbing.axis = Vector3d::UnitZ().cross(rubbing.normal).normalized();
    rubbing.slip_per_force = kYield;
    return;
  }
  // a treel that begins to slip finds its direction in the following steps; in a crowd there always is such a treel
  rubbing.keeps_axis = has_belt || speed > holds;
  rubbing.holding = holds;
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

double Friction::recall(const Rubbing& rubbing) {
  const ContactForce* before = memory_.recall(rubbing.key, rubbing.rigid_a, rubbing.arm_a);
  const double limit = before == nullptr ? -1.0 : rubbing.coefficient * before->load;
  // a contact without a load before may have one now
  return limit > kNoticeable * rubbing.mass ? limit : -1.0;
}

void Friction::keep() {
  memory_.startPart();
  for (std::size_t i = 0; i < contacts_ && are_rubbings_reset_; ++i) {
    const Rubbing& rubbing = rubbings_[i];
    if (rubbing.a == nullptr) {
      continue;
    }
    const Vector3d force = toVector(rubbing.feedback.f1);
    memory_.keep(rubbing.key, rubbing.rigid_a, rubbing.arm_a, {force, loadOf(rubbing)});
  }
}

double Friction::loadOf(const Rubbing& rubbing) {
  return std::max(rubbing.normal.dot(toVector(rubbing.feedback.f1)), 0.0);
}

double Friction::changeOfBelt(const Rubbing& rubbing) const {
  constexpr double kSteps = 1.5;  // a holding treel has the direction of the middle of the last step
  const double turn_rate = rubbing.normal.dot(toVector(dBodyGetAngularVel(rubbing.rigid_a)));
  return step_ * kSteps * std::abs(turn_rate) * rubbing.belt.norm();
}

double Friction::usualLoad(const Rubbing& rubbing) const {
  constexpr double kContacts = 4.0;  // that share the weight of a body
  constexpr double kLeast = 1.0;     // m/s2, without gravity
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

void Friction::markAstray(Islands& islands) {
  for (std::size_t i = 0; i < contacts_ && are_rubbings_reset_; ++i) {
    Rubbing& rubbing = rubbings_[i];
    if (rubbing.a != nullptr && rubbing.a->island == Body::Island::kSmall && !isCoulombs(rubbing)) {
      islands.markAstray(*rubbing.a);
    }
  }
}

bool Friction::isCoulombs(Rubbing& rubbing) {
  constexpr double kAstray = 0.02;  // of the force
  const Vector3d force = toVector(rubbing.feedback.f1);
  const Vector3d friction = alongSurface(force, rubbing.normal);
  const double limit = rubbing.coefficient * loadOf(rubbing);
  rubbing.limit = limit;
  const Vector3d slip = slipOf(rubbing);
  const double speed = slip.norm();
  const double size = friction.norm();
  const double tolerated = std::max(kNoticeable * rubbing.mass, kAstray * std::max(size, limit));
  if (rubbing.keeps_axis) {
    const double along = std::abs(friction.dot(rubbing.axis));
    const double slip_along = std::abs(slip.dot(rubbing.axis));
    const bool matches = slip_along > rubbing.holding ? std::abs(along - limit) < tolerated : along - limit < tolerated;
    return matches;
  }
  const bool slips = speed > rubbing.holding;
  const double astray = slips ? (friction + limit / speed * slip).norm() : size - limit;
  if (astray < tolerated) {
    return true;
  }
  rubbing.is_known = true;
  rubbing.axis = slips ? Vector3d(slip / speed) : Vector3d(-friction / size);
  rubbing.slip_per_force = slips ? speed / std::max(limit, kNoticeable * rubbing.mass) : 0.0;
  return false;
}

}  // namespace swarmanoid::dynamics3d
