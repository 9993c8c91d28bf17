// What Box2D sees, as lines.
#include <box2d/b2_contact.h>

#include "dynamics2d/dynamics2d.hpp"
#include "planar/draw_bodies.hpp"
#include "planar/gripper_reach.hpp"

namespace swarmanoid::dynamics2d {

using Kind = EngineDrawing::Kind;

void Dynamics2d::draw(EngineDrawing& drawing) const {
  PlanarEngine::draw(drawing);
  drawContacts(drawing);
  for (const BodyIndex index : movers_) {
    const RigidBody& rigid_body = rigid(index);
    if (rigid_body.grip.joint != nullptr) {
      const Eigen::Vector2d tip = planar::gripperTip(bodies_, index).position;
      planar::drawLine(bodies_, index, Kind::kJoint, bodies_[index].pose.position, tip, drawing);
      planar::drawLine(bodies_, index, Kind::kJoint, tip, bodies_[rigid_body.grip.gripped].pose.position, drawing);
    }
    drawForces(index, drawing);
  }
}

void Dynamics2d::drawContacts(EngineDrawing& drawing) const {
  constexpr double kLength = 0.05;  // m
  for (b2Contact* contact = world_->GetContactList(); contact != nullptr; contact = contact->GetNext()) {
    if (!contact->IsTouching()) {
      continue;
    }
    b2WorldManifold manifold;
    contact->GetWorldManifold(&manifold);
    const auto body = static_cast<BodyIndex>(contact->GetFixtureA()->GetBody()->GetUserData().pointer);
    for (int i = 0; i < contact->GetManifold()->pointCount; ++i) {
      const Eigen::Vector2d point = toMetres(manifold.points[i]);
      const Eigen::Vector2d normal(manifold.normal.x, manifold.normal.y);
      planar::drawLine(bodies_, body, Kind::kContact, point, point + kLength * normal, drawing);
    }
  }
}

void Dynamics2d::drawForces(BodyIndex index, EngineDrawing& drawing) const {
  const RigidBody& rigid_body = rigid(index);
  const auto line = [&](const Eigen::Vector2d& from, const Eigen::Vector2d& force) {
    planar::drawLine(bodies_, index, Kind::kForce, from, from + EngineDrawing::kMetresPerNewton * force, drawing);
  };
  if (rigid_body.belt.body == nullptr) {
    if (rigid_body.drive != Drive::kNone) {
      line(rigid_body.centre, rigid_body.last_push);
    }
    return;
  }
  for (b2FrictionJoint* treel : rigid_body.belt.treels) {
    line(toMetres(treel->GetAnchorB()), toMetres(treel->GetReactionForce(static_cast<float>(1.0 / last_step_))));
  }
}

}  // namespace swarmanoid::dynamics2d
