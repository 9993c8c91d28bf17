// What drives robots: treels that push on the ground, and flight.
//
// A robot that touches nobody gets in each step the forces that bring it to the commanded velocity within that step, as
// far as the ground holds; a treel that slips is held back against its slip. What else pushes it would come a step too
// late in that sum, so a robot that touches or holds anything is driven by joints instead, which Box2D solves together
// with the contacts.
#include <algorithm>
#include <cmath>

#include "dynamics2d/dynamics2d.hpp"
#include "dynamics2d/friction.hpp"
#include "dynamics2d/joints.hpp"

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

/// What treels push with that cannot all do what is asked of them: each with what the ground holds, against its slip.
/// One after the other, again and again, until none changes.
/// @param velocity, turn_rate of the centre of mass, beyond what is asked for; without any push
std::array<Eigen::Vector2d, 2> slippingTreels(const RigidBody& its, Eigen::Vector2d velocity, double turn_rate,
                                              double step) {
  constexpr int kMostSweeps = 100;
  constexpr double kSettled = 1e-7;  // of the traction
  std::array<Eigen::Vector2d, 2> forces{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  double change = 1.0;
  for (int sweep = 0; sweep < kMostSweeps && change > kSettled * its.traction; ++sweep) {
    change = 0.0;
    for (std::size_t i = 0; i < forces.size(); ++i) {
      const Eigen::Vector2d place = (i == 0 ? 0.5 : -0.5) * its.axle - its.arm;
      const Eigen::Vector2d across(-place.y(), place.x());
      const Eigen::Matrix2d yield =
          step * (Eigen::Matrix2d::Identity() / its.mass + across * across.transpose() / its.inertia);
      const Eigen::Vector2d slip = velocity + turn_rate * across;
      const Eigen::Vector2d force = coulombFriction(yield, slip - yield * forces[i], its.traction);
      const Eigen::Vector2d added = force - forces[i];
      forces[i] = force;
      velocity += step / its.mass * added;
      turn_rate += step / its.inertia * across.dot(added);
      change = std::max(change, added.norm());
    }
  }
  return forces;
}

/// @param velocity of the centre of mass at heading 0, @param spin before the step
Push treelPush(const RigidBody& its, const Eigen::Vector2d& velocity, double spin, double step) {
  const Eigen::Vector2d excess = velocity - its.centre_advance / step;
  const double turn_excess = spin - its.turn_rate;
  const Eigen::Vector2d force = -its.mass / step * excess;
  const double torque = -its.inertia / step * turn_excess;
  // both treels carry half of it, and push in opposite directions to turn
  const Eigen::Vector2d opposite = (torque + planar::cross(its.arm, force)) / its.track * its.ahead;
  Eigen::Vector2d left = 0.5 * force + opposite;
  Eigen::Vector2d right = 0.5 * force - opposite;
  if (std::max(left.squaredNorm(), right.squaredNorm()) > its.traction * its.traction) {
    const auto slipping = slippingTreels(its, excess, turn_excess, step);
    left = slipping[0];
    right = slipping[1];
  }
  const Eigen::Vector2d held = left + right;
  // the treels lie left and right of the origin, by half the track
  return {held, 0.5 * planar::cross(its.axle, left - right) - planar::cross(its.arm, held)};
}

/// Likewise.
Push flightPush(const RigidBody& its, const Eigen::Vector2d& velocity, double spin, double step) {
  const double most = its.inertia * kFlightTurnAcceleration;
  return {limited(its.mass / step * (its.centre_advance / step - velocity), its.mass * kFlightAcceleration),
          std::clamp(its.inertia / step * (its.turn_rate - spin), -most, most)};
}

Push pushOf(const RigidBody& its, const Eigen::Vector2d& velocity, double spin, double step) {
  return its.drive == Drive::kTreels ? treelPush(its, velocity, spin, step) : flightPush(its, velocity, spin, step);
}

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
    its.axle = body.entity->wheels->separation * model.left;
    its.track = body.entity->wheels->separation * planar::cross(model.left, model.ahead);
    its.traction = 0.5 * material_.treel_friction * its.mass * material_.gravity;
  }
}

void Dynamics2d::drive(BodyIndex index, double step, int step_number) {
  RigidBody& its = rigid(index);
  if (its.drive == Drive::kNone) {
    return;
  }
  if (its.drive == Drive::kTreels && !its.isFree() && its.belt.body == nullptr) {
    makeBelt(bodies_[index], its);
  }
  if (its.belt.body != nullptr) {
    moveBelt(its, step);
    return;
  }
  const b2Rot& turn = its.body->GetTransform().q;
  const Push push =
      pushOf(its, toMetres(b2MulT(turn, its.body->GetLinearVelocity())), its.body->GetAngularVelocity(), step);
  const b2Vec2 force = b2Mul(turn, toUnits(push.force));
  const auto torque = static_cast<float>(push.torque * kSquareUnits);
  its.last_push = toMetres(force);
  its.body->ApplyForceToCenter(force, false);
  its.body->ApplyTorque(torque, false);
  recordPush(its, step_number, force, torque);
}

void Dynamics2d::driveAlone(RigidBody& its, double step, int step_number) {
  const planar::PlacedPose pose = planar::PlacedPose::at(its.centre, its.heading);
  const Push push = pushOf(its, pose.unrotated(its.velocity), its.spin, step);
  its.last_push = pose.rotated(push.force);
  its.velocity += step / its.mass * its.last_push;
  its.spin += step / its.inertia * push.torque;
  its.centre += step * its.velocity;
  its.heading = planar::wrapAngle(its.heading + step * its.spin);
  for (int i = 0; i < pieces_; ++i) {
    recordPush(its, step_number * pieces_ + i, toUnits(its.last_push), static_cast<float>(push.torque * kSquareUnits));
  }
}

void Dynamics2d::recordPush(const RigidBody& its, int step_number, const b2Vec2& force, float torque) {
  if (recording_ != nullptr) {
    recording_->of(step_number, its.ordinal) = {force, torque};
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
    its.belt.treels[i] = makeJoint<TreelJoint, b2FrictionJoint>(*world_, treel);
  }
}

void Dynamics2d::moveBelt(RigidBody& its, double step) {
  its.belt.body->SetTransform(its.body->GetPosition(), its.body->GetAngle());
  its.belt.body->SetLinearVelocity(b2Mul(its.body->GetTransform().q, toUnits(its.origin_advance / step)));
  its.belt.body->SetAngularVelocity(static_cast<float>(its.turn_rate));
}

void Dynamics2d::recordBelts(double step, int step_number) {
  const auto frequency = static_cast<float>(1.0 / step);
  for (const BodyIndex index : present_) {
    const RigidBody& its = rigid(index);
    if (its.belt.body == nullptr) {
      continue;
    }
    b2Vec2 pushed(0.0F, 0.0F);
    float turned = 0.0F;
    for (b2FrictionJoint* treel : its.belt.treels) {
      const b2Vec2 force = treel->GetReactionForce(frequency);
      pushed += force;
      turned += b2Cross(treel->GetAnchorB() - treel->GetBodyB()->GetWorldCenter(), force);
    }
    recordPush(its, step_number, pushed, turned);
  }
}

void Dynamics2d::dropBelt(RigidBody& its) {
  if (its.belt.body != nullptr) {
    world_->DestroyBody(its.belt.body);  // and its joints
    its.belt = Belt{};
  }
}

}  // namespace swarmanoid::dynamics2d
