// What drives robots: treels that push on the ground, and flight.
//
// A robot that touches nobody gets in each step the force that brings it to the commanded velocity within that step, as
// far as the ground holds. What else pushes it would come a step too late in that sum, so a robot that touches or holds
// anything is driven by joints instead, which Box2D solves together with the contacts.
#include <algorithm>
#include <cmath>

#include "dynamics2d/dynamics2d.hpp"

namespace swarmanoid::dynamics2d {
namespace {

constexpr double kFlightAcceleration = 4.0;       // m/s2
constexpr double kFlightTurnAcceleration = 20.0;  // rad/s2

Eigen::Vector2d limited(const Eigen::Vector2d& force, double most) {
  const double squared = force.squaredNorm();
  return squared > most * most ? Eigen::Vector2d(force * (most / std::sqrt(squared))) : force;
}

/// Where a treel touches the ground, at heading 0. @param side 1: left, -1: right
Eigen::Vector2d treelPosition(const Body& body, double side) {
  return side * 0.5 * body.entity->wheels->separation * body.model->left;
}

Eigen::Vector2d toBodyFrame(const b2Rot& turn, const b2Vec2& velocity) { return toMetres(b2MulT(turn, velocity)); }

}  // namespace

void Dynamics2d::prepareDrive(BodyIndex index, double step) {
  const Body& body = bodies_[index];
  RigidBody& its = rigid(index);
  const planar::PlacedPose end = planar::integrate(planar::PlacedPose{}, body.velocity, body.turn_rate, step);
  its.origin_advance = end.position;
  its.centre_advance = end.position + end.rotated(its.arm) - its.arm;
  its.turn_rate = body.turn_rate;
  its.drive = body.wheels != nullptr ? Drive::kTreels : Drive::kFlight;
  if (body.wheels != nullptr) {
    const PlanarModel& model = *body.model;
    its.ahead = model.ahead;
    its.track = body.entity->wheels->separation * planar::cross(model.left, model.ahead);
    its.traction = 0.5 * material_.treel_friction * its.mass * material_.gravity;
  }
}

void Dynamics2d::drive(BodyIndex index, double step) {
  RigidBody& its = rigid(index);
  if (its.drive == Drive::kNone) {
    return;
  }
  if (recorded_pushes_ != nullptr) {
    recorded_pushes_->emplace_back();
  }
  if (its.drive == Drive::kFlight) {
    fly(its, step);
  } else if (its.belt.body != nullptr) {
    moveBelt(its, step);
  } else if (its.isFree()) {
    driveTreels(its, step);
  } else {
    makeBelt(bodies_[index], its);
    moveBelt(its, step);
  }
}

void Dynamics2d::driveTreels(RigidBody& its, double step) {
  const b2Rot& turn = its.body->GetTransform().q;
  const Eigen::Vector2d velocity = toBodyFrame(turn, its.body->GetLinearVelocity());
  const Eigen::Vector2d force = its.mass / step * (its.centre_advance / step - velocity);
  const double torque = its.inertia / step * (its.turn_rate - its.body->GetAngularVelocity());
  // both treels carry half of it, and push in opposite directions to turn
  const Eigen::Vector2d opposite = (torque + planar::cross(its.arm, force)) / its.track * its.ahead;
  const Eigen::Vector2d left = limited(0.5 * force + opposite, its.traction);
  const Eigen::Vector2d right = limited(0.5 * force - opposite, its.traction);
  const Eigen::Vector2d held = left + right;
  // the treels lie left and right of the origin, by half the track
  const double turned = 0.5 * its.track * its.ahead.dot(left - right) - planar::cross(its.arm, held);
  push(its, held, turned);
}

void Dynamics2d::fly(RigidBody& its, double step) {
  const Eigen::Vector2d velocity = toBodyFrame(its.body->GetTransform().q, its.body->GetLinearVelocity());
  const Eigen::Vector2d force =
      limited(its.mass / step * (its.centre_advance / step - velocity), its.mass * kFlightAcceleration);
  const double most = its.inertia * kFlightTurnAcceleration;
  push(its, force, std::clamp(its.inertia / step * (its.turn_rate - its.body->GetAngularVelocity()), -most, most));
}

void Dynamics2d::push(RigidBody& its, const Eigen::Vector2d& force, double torque) {
  const b2Vec2 pushed = b2Mul(its.body->GetTransform().q, toUnits(force));
  const auto turned = static_cast<float>(torque * kSquareUnits);
  its.last_push = pushed;
  its.body->ApplyForceToCenter(pushed, false);
  its.body->ApplyTorque(turned, false);
  if (recorded_pushes_ != nullptr) {
    recorded_pushes_->back() = {pushed, turned};
  }
}

void Dynamics2d::makeBelt(const Body& body, RigidBody& its) {
  b2BodyDef definition;
  definition.type = b2_kinematicBody;
  definition.position = its.body->GetPosition();
  definition.angle = its.body->GetAngle();
  its.belt.body = world_->CreateBody(&definition);
  for (std::size_t i = 0; i < its.belt.treels.size(); ++i) {
    b2FrictionJointDef treel;
    treel.bodyA = its.belt.body;
    treel.bodyB = its.body;
    treel.localAnchorA = toUnits(treelPosition(body, i == 0 ? 1.0 : -1.0));
    treel.localAnchorB = treel.localAnchorA;
    treel.maxForce = static_cast<float>(its.traction * kUnitsPerMetre);
    its.belt.treels[i] = static_cast<b2FrictionJoint*>(world_->CreateJoint(&treel));
  }
}

void Dynamics2d::moveBelt(RigidBody& its, double step) {
  its.belt.body->SetTransform(its.body->GetPosition(), its.body->GetAngle());
  its.belt.body->SetLinearVelocity(b2Mul(its.body->GetTransform().q, toUnits(its.origin_advance / step)));
  its.belt.body->SetAngularVelocity(static_cast<float>(its.turn_rate));
}

void Dynamics2d::recordBelts(double step) {
  auto push = recorded_pushes_->end();
  const auto frequency = static_cast<float>(1.0 / step);
  for (auto index = movers_.rbegin(); index != movers_.rend(); ++index) {
    const RigidBody& its = rigid(*index);
    if (its.drive == Drive::kNone) {
      continue;
    }
    --push;
    for (b2FrictionJoint* treel : its.belt.treels) {
      if (treel != nullptr) {
        const b2Vec2 force = treel->GetReactionForce(frequency);
        push->force += force;
        push->torque += b2Cross(treel->GetAnchorB() - treel->GetBodyB()->GetWorldCenter(), force);
      }
    }
  }
}

void Dynamics2d::dropBelt(RigidBody& its) {
  if (its.belt.body != nullptr) {
    world_->DestroyBody(its.belt.body);  // and its joints
    its.belt = Belt{};
  }
}

}  // namespace swarmanoid::dynamics2d
