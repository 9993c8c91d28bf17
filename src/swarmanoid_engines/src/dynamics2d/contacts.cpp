// A mirror cannot be held back, and may be put upon others. Box2D would push them out of it by decimetres within a
// step, through walls too, or so far into one that they hang on it, to be shot away later. So whatever is in a mirror
// looks to Box2D as if it were in it by no more than it may come out in a step.
#include "dynamics2d/contacts.hpp"

#include <algorithm>

namespace swarmanoid::dynamics2d {
namespace {

bool isMirror(const b2Fixture& fixture) { return fixture.GetBody()->GetType() == b2_kinematicBody; }

/// @param by how much less deep the contact is to look; in Box2D's units
/// @param normal from a to b
void makeShallower(b2Contact& contact, const b2Vec2& normal, float by) {
  b2Manifold& manifold = *contact.GetManifold();
  if (manifold.type == b2Manifold::e_circles) {
    const b2Rot& turn = contact.GetFixtureA()->GetBody()->GetTransform().q;
    manifold.localPoint -= by * b2MulT(turn, normal);  // the centre of a's circle goes away from b's
  } else {
    manifold.localPoint -= by * manifold.localNormal;  // a side of a polygon goes back into it
  }
}

}  // namespace

void Contacts::PreSolve(b2Contact* contact, const b2Manifold*) {
  if (!isMirror(*contact->GetFixtureA()) && !isMirror(*contact->GetFixtureB())) {
    return;
  }
  b2WorldManifold meeting;
  contact->GetWorldManifold(&meeting);
  const float* separations = meeting.separations;
  const float depth = -*std::min_element(separations, separations + contact->GetManifold()->pointCount);
  if (depth > deepest_) {
    makeShallower(*contact, meeting.normal, depth - deepest_);
  }
}

}  // namespace swarmanoid::dynamics2d
