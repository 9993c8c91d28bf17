#include "dynamics3d/contacts/contacts.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics3d/mechanisms/treels.hpp"
#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid::dynamics3d {
namespace {

constexpr double kBounceSpeed = 0.02;  // m/s: slower impacts do not bounce

// A mirror does not yield. Forces on a body crushed between a mirror and a wall must stay below some hundred newtons:
// without a limit, a contact found a little beside the right place spins the body like a top.
constexpr double kMirrorSoftness = 1e-3;  // m/s per N

bool isMirror(const Body* body) { return body != nullptr && body->rigid != nullptr && !body->is_dynamic; }

/// Separation direction for solids that were placed into each other: their normals may contradict each other, or lead
/// into the ground, so deep ones separate horizontally, along the line between them. @param into_a the contact's normal
Eigen::Vector3d wayOut(const Body& a, const Body& b, double depth, const Eigen::Vector3d& into_a) {
  constexpr double kDeep = 5e-3;  // m: not reached by motion
  constexpr double kSame = 1e-6;  // m
  Eigen::Vector3d way = toVector(dBodyGetPosition(a.rigid)) - toVector(dBodyGetPosition(b.rigid));
  way.z() = 0.0;
  return depth < kDeep || way.norm() < kSame ? into_a : way.normalized();
}

/// Whether the current step moves the body.
bool isEnabled(const Body* body) {
  return body != nullptr && body->rigid != nullptr && dBodyIsEnabled(body->rigid) != 0;
}

}  // namespace

void Contacts::configure(dWorldID world, const Settings& settings) {
  SWARMANOID_EXPECTS(OdeLock::isHeld());
  settings_ = settings;
  world_ = world;
  joints_ = dJointGroupCreate(0);
  most_bodies_ = 0;
}

void Contacts::release() {
  SWARMANOID_EXPECTS(OdeLock::isHeld());
  if (joints_ != nullptr) {
    dJointGroupDestroy(joints_);
    joints_ = nullptr;
  }
  forget();
}

void Contacts::startStep(std::size_t bodies) {
  memory_.startStep();
  bodies_ = bodies;
  if (bodies <= most_bodies_) {
    return;
  }
  most_bodies_ = bodies;
  memory_.reserve(kMostTouchesOfABody * bodies);
  const dContact none = {};
  for (std::size_t i = 0; i < kMostTouchesOfABody * bodies; ++i) {
    dJointCreateContact(world_, joints_, &none);
  }
  dJointGroupEmpty(joints_);
}

void Contacts::make(const std::vector<Touch>& touches, double step, int attempt, bool is_iterative) {
  step_ = step;
  attempt_ = attempt;
  memory_.rewind();
  friction_.startStep(step, settings_.gravity, touches.size(), attempt == 0 && !is_iterative);
  solver_.startStep(world_, step, bodies_);
  makeAll(touches);
}

void Contacts::makeAgain(const std::vector<Touch>& touches) {
  friction_.startAgain();
  makeAll(touches);
}

void Contacts::makeAll(const std::vector<Touch>& touches) {
  for (std::size_t i = 0; i < touches.size(); ++i) {
    if (isEnabled(touches[i].a) || isEnabled(touches[i].b)) {
      makeOne(touches[i], i);
    }
  }
}

void Contacts::makeOne(const Touch& touch, std::size_t number) {
  dContact contact = {};
  if (!describe(touch, contact)) {
    return;
  }
  if (touch.a->island == Body::Island::kContacts) {
    solver_.add(*touch.a, touch.b, contact);
    return;
  }
  const dBodyID rigid_a = dGeomGetBody(touch.solid_a->geom);
  const dBodyID rigid_b = touch.b == nullptr ? nullptr : dGeomGetBody(touch.solid_b->geom);
  friction_.lay(number, *touch.a, rigid_a, touch.b, rigid_b, contact);
  breakTies(number, contact.surface);
  const dJointID joint = dJointCreateContact(world_, joints_, &contact);
  dJointAttach(joint, rigid_a, rigid_b);
  friction_.watch(number, joint);
}

bool Contacts::describe(const Touch& touch, dContact& contact) const {
  const Body& a = *touch.a;
  const Body* b = touch.b;
  contact.geom = touch.geometry;
  contact.geom.depth -= kMargin;  // below 0: a gap
  const double depth = contact.geom.depth;
  contact.surface.mode = dContactApprox1;
  contact.surface.mu = settings_.friction;
  if (b != nullptr && (isMirror(&a) || isMirror(b))) {
    Eigen::Map<Eigen::Vector3d>(contact.geom.normal) = wayOut(a, *b, depth, toVector(contact.geom.normal));
    contact.surface.mode |= dContactSoftCFM;
    contact.surface.soft_cfm = kMirrorSoftness;
  }
  if (settings_.restitution > 0.0) {
    const Eigen::Vector3d point = toVector(contact.geom.pos);
    const dBodyID rigid_b = b == nullptr ? nullptr : dGeomGetBody(touch.solid_b->geom);
    const double approach =
        -toVector(contact.geom.normal)
             .dot(velocityAt(dGeomGetBody(touch.solid_a->geom), point) - velocityAt(rigid_b, point));
    if (approach > kBounceSpeed) {
      if (depth < 0.0) {
        return false;  // slowed down to the gap, the body would bounce lower
      }
      contact.surface.mode |= dContactBounce;
      contact.surface.bounce = settings_.restitution;
      contact.surface.bounce_vel = kBounceSpeed;
    }
  }
  contact.surface.mode |= dContactMotionN;
  contact.surface.motionN = std::min(depth, 0.0) / step_;
  if (touch.solid_a->kind != Solid::Kind::kPlain) {
    driveContact(a, *touch.solid_a, settings_, step_, contact);
  }
  return true;
}

void Contacts::breakTies(std::size_t number, dSurfaceParameters& surface) const {
  // The exact solver gives up where contacts tie, such as those of a symmetric robot at rest. These speeds are all
  // different, and too small to be noticed.
  constexpr double kMost = 1e-9;          // m/s
  constexpr double kMostFriction = 1e-6;  // of the coefficient
  constexpr double kGoldenRatio = 0.618033988749895;
  constexpr int kOtherNumbers = 997;
  const double shift = std::fmod((static_cast<int>(number) + 1 + kOtherNumbers * attempt_) * kGoldenRatio, 1.0);
  surface.motionN -= (1 + attempt_) * kMost * shift;
  if (attempt_ > 0) {
    surface.mu *= 1.0 - kMostFriction * shift;
  }
}

}  // namespace swarmanoid::dynamics3d
