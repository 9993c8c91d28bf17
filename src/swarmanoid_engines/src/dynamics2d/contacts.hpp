/// Which pairs of bodies may touch, which bodies touch another, and how hard mirrors push.
#pragma once

#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_world_callbacks.h>

#include <algorithm>
#include <vector>

#include "dynamics2d/rigid_body.hpp"

namespace swarmanoid::dynamics2d {

/// Shapes whose bands of heights do not overlap pass over each other. The body's number is in Box2D's user data, and
/// that of the shape in its fixtures'.
class Contacts final : public b2ContactFilter, public b2ContactListener {
 public:
  Contacts(const planar::Bodies& bodies, std::vector<RigidBody>& rigid_bodies)
      : bodies_(bodies), rigid_bodies_(rigid_bodies) {}

  /// Before the steps of a tick. @param step that they have [s]
  void setStep(double step) {
    // m/s: what a mirror is put upon leaves it with half of that, since Box2D takes away no more of a depth in a step
    constexpr double kFastestOut = 0.3;
    deepest_ = std::max(toUnits(kFastestOut * step), 3.0F * b2_linearSlop);
  }

  bool ShouldCollide(b2Fixture* a, b2Fixture* b) override {
    const Body& body_a = bodies_[indexOf(a)];
    const Body& body_b = bodies_[indexOf(b)];
    return shapeOf(body_a, a).band.overlaps(shapeOf(body_b, b).band, body_a.along, body_b.along);
  }
  void BeginContact(b2Contact* contact) override { count(*contact, 1); }
  void EndContact(b2Contact* contact) override { count(*contact, -1); }
  /// Before each step, of what touches.
  void PreSolve(b2Contact* contact, const b2Manifold* before) override;

 private:
  static BodyIndex indexOf(b2Fixture* fixture) {
    return static_cast<BodyIndex>(fixture->GetBody()->GetUserData().pointer);
  }
  static const planar::PlanarShape& shapeOf(const Body& body, b2Fixture* fixture) {
    return body.model->shapes[fixture->GetUserData().pointer];
  }
  void count(b2Contact& contact, int change) {
    for (b2Fixture* fixture : {contact.GetFixtureA(), contact.GetFixtureB()}) {
      rigid_bodies_[static_cast<std::size_t>(indexOf(fixture))].touching += change;
    }
  }

  const planar::Bodies& bodies_;
  std::vector<RigidBody>& rigid_bodies_;
  float deepest_ = 0.0F;  // what contacts with mirrors look like at most, in Box2D's units
};

}  // namespace swarmanoid::dynamics2d
