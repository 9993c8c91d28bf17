// Phase `move`: Box2D steps the bodies; the space gets their poses in double precision.
#include <algorithm>
#include <cmath>

#include "dynamics2d/dynamics2d.hpp"

namespace swarmanoid::dynamics2d {

void Dynamics2d::readMirrors(const Space& space) {
  for (const BodyIndex index : bodies_.order()) {
    const Body& body = bodies_[index];
    if (body.role == Role::kMirror && body.is_movable) {
      takePose(space, index);
    }
  }
}

void Dynamics2d::move(Space& space, Duration dt) {
  constexpr int kPositionIterations = 3;
  const double step = toSeconds(dt) / subclock_;
  last_step_ = step;
  startTick(space, step);
  for (const BodyIndex index : movers_) {
    drive(index, step);
  }
  for (int i = 1; i <= subclock_; ++i) {
    driveTurrets(step);
    world_->Step(static_cast<float>(step), material_.iterations, kPositionIterations);
    if (recorded_pushes_ != nullptr) {
      recordBelts(step);
    }
    for (const BodyIndex index : movers_) {
      rigid(index).readStep(step);
      if (i < subclock_) {
        drive(index, step);
      }
    }
    readTurrets(step);
    tearGrips(step);
  }
  finishTick(space);
  finishTurrets(space);
}

void Dynamics2d::startTick(const Space& space, double step) {
  bodies_.findLateDevices(space);
  for (const BodyIndex index : newcomers_) {
    meetGround(index);
  }
  newcomers_.clear();
  bool may_tunnel = false;
  for (const BodyIndex index : movers_) {
    Body& body = bodies_[index];
    RigidBody& its = rigid(index);
    if (its.belt.body != nullptr && its.isFree()) {
      dropBelt(its);
    }
    if (body.wheels != nullptr || body.flight != nullptr) {
      readCommands(body);
      prepareDrive(index, step);
    }
    may_tunnel = may_tunnel || mayTunnel(index, step);
  }
  // times of impact are dear, and only what moves far in a step needs them
  world_->SetContinuousPhysics(may_tunnel);
}

bool Dynamics2d::mayTunnel(BodyIndex index, double step) const {
  constexpr double kSafe = 0.25;  // of the thickness: a push on top of it is still safe
  const RigidBody& its = rigid(index);
  const double most = kSafe * its.thickness;
  const double way_squared = toMetres(its.body->GetLinearVelocity()).squaredNorm() * step * step;
  return std::max(way_squared, its.centre_advance.squaredNorm()) > most * most;
}

void Dynamics2d::meetGround(BodyIndex index) {
  const Body& body = bodies_[index];
  const RigidBody& its = rigid(index);
  if (body.wheels != nullptr || body.flight != nullptr) {
    return;
  }
  b2FrictionJointDef definition;
  definition.bodyA = ground_;
  definition.bodyB = its.body;
  definition.localAnchorA = its.body->GetWorldCenter();
  definition.localAnchorB = its.body->GetLocalCenter();
  definition.collideConnected = true;
  rigid(index).ground = static_cast<b2FrictionJoint*>(world_->CreateJoint(&definition));
  setGroundFriction(index);
}

void Dynamics2d::setGroundFriction(BodyIndex index) {
  const RigidBody& its = rigid(index);
  if (its.ground == nullptr) {
    return;
  }
  // pressed evenly on a disc that is as wide as the body, friction resists turning on two thirds of its radius
  const double force = material_.ground_friction * its.mass * material_.gravity;
  const double radius = bodies_[index].model->radius;
  its.ground->SetMaxForce(static_cast<float>(force * kUnitsPerMetre));
  its.ground->SetMaxTorque(static_cast<float>(force * 2.0 / 3.0 * radius * kSquareUnits));
}

void Dynamics2d::finishTick(Space& space) {
  const planar::Plane& plane = bodies_.plane();
  for (const BodyIndex index : movers_) {
    RigidBody& its = rigid(index);
    const planar::PlacedPose pose = its.pose();
    Twist& twist = space.entities.twist[static_cast<std::size_t>(bodies_[index].row)];
    const Eigen::Vector2d arm = pose.rotated(its.arm);
    const double turn_rate = its.body->GetAngularVelocity();
    const Eigen::Vector2d velocity =
        toMetres(its.body->GetLinearVelocity()) - turn_rate * Eigen::Vector2d(-arm.y(), arm.x());
    twist.linear = plane.toGlobal(velocity, 0.0);
    twist.angular = plane.normal() * turn_rate;
    const planar::PlacedPose before = bodies_[index].pose;
    if (pose.position != before.position || pose.heading != before.heading) {
      bodies_.setPose(index, pose);
      writePose(space, index, before.heading);
    }
  }
}

}  // namespace swarmanoid::dynamics2d
