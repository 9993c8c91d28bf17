// Phase `move`: Box2D steps the bodies; the space gets their poses in double precision.
#include <algorithm>
#include <cmath>

#include "dynamics2d/dynamics2d.hpp"

namespace swarmanoid::dynamics2d {

/// In how many pieces each step is made in this tick, so that nothing in Box2D moves or turns by more in one than it
/// may; and whether anything moves by so much that times of impact are needed, which are dear.
void Dynamics2d::choosePieces(double step) {
  // Box2D bears no longer ways and no larger turns, and a body that is hit may be twice as fast as its hitter
  constexpr double kMostWay = 0.5 * kLongestWay;                           // m
  constexpr double kMostTurn = 0.5 * static_cast<double>(b2_maxRotation);  // rad
  // contacts and grips are solved where they are when a step begins, and should not be far from there when it ends
  constexpr double kWayAtContact = 0.01;  // m
  constexpr double kWayInGrip = 0.002;    // m: Box2D stops a body that runs into something, whatever holds it
  constexpr double kTurnOfHeld = 0.03;    // rad
  // and the solver takes many steps to forget the push of a robot that pushes no longer
  constexpr double kTimeOfHeld = 0.05;  // s
  constexpr double kMostPieces = 1e4;
  double rate = 0.0;     // of pieces [1/s]
  double fastest = 0.0;  // surface [m/s]
  const auto include = [&](BodyIndex index, bool is_held) {
    const Rates most = highestRates(index);
    const double way_of_held = rigid(index).isConnected() ? kWayInGrip : kWayAtContact;
    fastest = std::max(fastest, most.speed + most.turn * bodies_[index].model->radius);
    rate = is_held ? std::max({rate, most.speed / way_of_held, most.turn / kTurnOfHeld, 1.0 / kTimeOfHeld})
                   : std::max({rate, most.speed / kMostWay, most.turn / kMostTurn});
  };
  for (const BodyIndex index : present_) {
    include(index, !rigid(index).isFree());
  }
  for (const BodyIndex index : mirrors_) {
    if (!present_.empty() && (!rigid(index).is_fast || rigid(index).is_reached)) {
      include(index, false);
    }
  }
  pieces_ = static_cast<int>(std::ceil(std::clamp(rate * step, 1.0, kMostPieces)));
  last_step_ = step / pieces_;
  contacts_.setStep(last_step_);
  world_->SetContinuousPhysics(fastest * last_step_ > kSlop);
}

void Dynamics2d::readMirrors(const Space& space) {
  mirrors_.clear();
  for (const BodyIndex index : bodies_.order()) {
    const Body& body = bodies_[index];
    if (body.role == Role::kMirror && body.is_movable) {
      const Eigen::Vector2d before = body.pose.position;
      const double radius = body.model->radius;
      takePose(space, index);
      mirrors_.push_back(index);
      rigid(index).jump = (body.pose.position - before).norm() + std::max(0.0, body.model->radius - radius);
    }
  }
}

void Dynamics2d::move(Space& space, Duration dt) {
  startTick(space, toSeconds(dt));
  moveAlone(toSeconds(dt));
  if (!present_.empty() || !mirrors_.empty()) {  // moved mirrors are noted in Box2D until it steps
    moveInBox2d();
  }
  finishTick(space, toSeconds(dt));
  finishTurrets(space);
}

void Dynamics2d::moveInBox2d() {
  constexpr int kPositionIterations = 3;
  const int steps = subclock_ * pieces_;
  const double step = last_step_;
  for (const BodyIndex index : present_) {
    drive(index, step);
  }
  for (int i = 0; i < steps; ++i) {
    driveTurrets(step);
    world_->Step(static_cast<float>(step), material_.iterations, kPositionIterations);
    for (const BodyIndex index : present_) {
      rigid(index).readStep(step);
      if (i + 1 < steps) {
        drive(index, step);
      }
    }
    readTurrets(step);
    readGrips(step);
    if ((i + 1) % pieces_ == 0) {
      tearGrips(pieces_ * step);
    }
  }
}

void Dynamics2d::startTick(const Space& space, double tick) {
  bodies_.readTurretCommands(space);
  longest_way_ = 0.0;
  longest_slow_way_ = 0.0;
  for (const BodyIndex index : movers_) {
    Body& body = bodies_[index];
    if (body.isDriven()) {
      readCommands(space, body);
    }
    measureWay(index, tick, 0.0);
  }
  for (const BodyIndex index : mirrors_) {
    measureWay(index, tick, rigid(index).jump);
  }
  sortOut();
  for (const BodyIndex index : present_) {
    RigidBody& rigid_body = rigid(index);
    if (rigid_body.belt.body != nullptr && rigid_body.isFree()) {
      dropBelt(rigid_body);
    }
  }
  const double nominal = tick / subclock_;
  choosePieces(nominal);
  for (const BodyIndex index : movers_) {
    if (bodies_[index].isDriven()) {
      prepareDrive(index, rigid(index).isAlone() ? nominal : last_step_);
    }
  }
}

void Dynamics2d::joinGround(BodyIndex index) {
  RigidBody& rigid_body = rigid(index);
  b2FrictionJointDef definition;
  definition.bodyA = ground_;
  definition.bodyB = rigid_body.body;
  definition.localAnchorA = rigid_body.body->GetWorldCenter();
  definition.localAnchorB = rigid_body.body->GetLocalCenter();
  definition.collideConnected = true;
  rigid_body.ground = static_cast<b2FrictionJoint*>(world_->CreateJoint(&definition));
  setGroundFriction(index);
}

void Dynamics2d::setGroundFriction(BodyIndex index) {
  const RigidBody& rigid_body = rigid(index);
  if (rigid_body.ground == nullptr) {
    return;
  }
  // pressed evenly on a disc that is as wide as the body, friction resists turning on two thirds of its radius
  const double force = material_.ground_friction * rigid_body.mass * material_.gravity;
  const double radius = bodies_[index].model->radius;
  rigid_body.ground->SetMaxForce(static_cast<float>(force * kUnitsPerMetre));
  rigid_body.ground->SetMaxTorque(static_cast<float>(force * 2.0 / 3.0 * radius * kSquareUnits));
}

void Dynamics2d::finishTick(Space& space, double tick) {
  const planar::Plane& plane = bodies_.plane();
  for (const BodyIndex index : movers_) {
    const RigidBody& rigid_body = rigid(index);
    const planar::PlacedPose before = bodies_[index].pose;
    const planar::PlacedPose pose = rigid_body.pose(before);
    turnWheels(space, bodies_[index], tick);
    Twist& twist = space.entities.twist[bodies_[index].row];
    const Eigen::Vector2d arm = pose.rotated(rigid_body.arm);
    const double turn_rate = rigid_body.spinNow();
    const Eigen::Vector2d velocity = rigid_body.velocityNow() - turn_rate * Eigen::Vector2d(-arm.y(), arm.x());
    twist.linear = plane.toGlobal(velocity, 0.0);
    twist.angular = plane.normal() * turn_rate;
    if (pose.position != before.position || pose.heading != before.heading) {
      bodies_.setPose(index, pose);
      writePose(space, index, before.heading);
    }
  }
}

}  // namespace swarmanoid::dynamics2d
