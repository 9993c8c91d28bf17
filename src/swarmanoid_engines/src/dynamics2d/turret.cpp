// Turrets: motors between robots and what they hold; grippers that turn without load.
#include <box2d/b2_circle_shape.h>
#include <box2d/b2_distance.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_polygon_shape.h>
#include <box2d/b2_revolute_joint.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "dynamics2d/dynamics2d.hpp"
#include "dynamics2d/fixtures.hpp"
#include "dynamics2d/joints.hpp"
#include "swarmanoid_interface/angle.hpp"

namespace swarmanoid::dynamics2d {

using planar::Turret;

namespace {

/// The motor between a robot and what it holds; null if there is none.
b2RevoluteJoint* motorOf(const RigidBody& robot) {
  b2Joint* joint = robot.grip.joint;
  return joint != nullptr && joint->GetType() == e_revoluteJoint ? static_cast<b2RevoluteJoint*>(joint) : nullptr;
}

bool areJoined(b2Body& a, const b2Body& b) {
  for (const b2JointEdge* edge = a.GetJointList(); edge != nullptr; edge = edge->next) {
    if (edge->other == &b && !edge->joint->GetCollideConnected()) {
      return true;
    }
  }
  return false;
}

/// How far a fixture, were it of another shape, would be from those of other bodies; below 0 where it would be in them.
/// In Box2D's units.
class Separation final : public b2QueryCallback {
 public:
  Separation(b2Fixture& fixture, const b2Shape& shape, b2ContactFilter& filter)
      : fixture_(fixture), body_(*fixture.GetBody()), shape_(shape), filter_(filter) {}

  float find() {
    b2AABB box;
    shape_.ComputeAABB(&box, body_.GetTransform(), 0);
    body_.GetWorld()->QueryAABB(this, box);
    return least_;
  }

  bool ReportFixture(b2Fixture* other) override {
    b2Body& its_body = *other->GetBody();
    if (&its_body == &body_ || !filter_.ShouldCollide(&fixture_, other) || areJoined(body_, its_body)) {
      return true;
    }
    b2DistanceInput input;
    input.proxyA.Set(&shape_, 0);
    input.proxyB.Set(other->GetShape(), 0);
    input.transformA = body_.GetTransform();
    input.transformB = other->GetBody()->GetTransform();
    input.useRadii = false;
    b2SimplexCache cache;
    cache.count = 0;
    b2DistanceOutput output;
    b2Distance(&output, &cache, &input);
    least_ = std::min(least_, output.distance - shape_.m_radius - other->GetShape()->m_radius);
    return true;
  }

 private:
  b2Fixture& fixture_;
  b2Body& body_;
  const b2Shape& shape_;
  b2ContactFilter& filter_;
  float least_ = std::numeric_limits<float>::infinity();
};

}  // namespace

void Dynamics2d::driveTurrets(double step) {
  for (Turret& turret : bodies_.turrets()) {
    if (rigid(turret.body).isAlone()) {
      continue;
    }
    b2RevoluteJoint* motor = motorOf(rigid(turret.body));
    if (motor == nullptr) {
      turnFreely(turret, step);
      continue;
    }
    motor->EnableMotor(turret.command.mode != JointCommand::Mode::kPassive);
    const double speed = motorSpeed(turret.command, bodies_.jointOf(turret), turret.state.angle, step);
    motor->SetMotorSpeed(static_cast<float>(turret.sense * speed));
  }
}

void Dynamics2d::turnFreely(Turret& turret, double step) {
  const double angle = freeTurn(turret.command, bodies_.jointOf(turret), turret.state.angle, step);
  turret.state.speed = 0.0;
  turret.state.effort = 0.0;
  if (angle == turret.state.angle) {
    return;
  }
  if (!rigid(turret.body).isAlone()) {
    const double reached = separation(turret, bodies_.modelAt(turret, angle));
    constexpr double kTouching = -2.0 * kWidening;
    if (reached < kTouching && reached < separation(turret, *bodies_[turret.body].model)) {
      return;
    }
  }
  turret.state.speed = wrapTurn(angle - turret.state.angle) / step;
  turret.state.angle = angle;
  turnGripper(turret);
}

double Dynamics2d::separation(const Turret& turret, const PlanarModel& model) {
  const Body& body = bodies_[turret.body];
  float least = std::numeric_limits<float>::infinity();
  b2Fixture* fixture = rigid(turret.body).body->GetFixtureList();
  for (; fixture != nullptr; fixture = fixture->GetNext()) {
    const std::size_t i = fixture->GetUserData().pointer;
    if (body.entity->shapes[i].joint != turret.joint) {
      continue;
    }
    const planar::PlanarShape& shape = model.shapes[i];
    b2CircleShape circle;
    b2PolygonShape polygon;
    if (shape.isCircle()) {
      setShape(shape, circle);
      least = std::min(least, Separation(*fixture, circle, contacts_).find());
    } else {
      setShape(shape, polygon);
      least = std::min(least, Separation(*fixture, polygon, contacts_).find());
    }
  }
  return static_cast<double>(least) / kUnitsPerMetre;
}

void Dynamics2d::turnGripper(const Turret& turret) {
  RigidBody& rigid_body = rigid(turret.body);
  bodies_.turnShapes(turret, turret.state.angle);
  if (!rigid_body.isAlone()) {
    turnFixtures(*rigid_body.body, *bodies_[turret.body].model, *bodies_[turret.body].entity, turret.joint);
    rigid_body.writeTransform();  // Box2D looks anew where the fixtures are
  }
}

b2Joint* Dynamics2d::makeTurretJoint(Turret& turret, BodyIndex gripped) {
  const RigidBody& robot = rigid(turret.body);
  const RigidBody& held = rigid(gripped);
  b2RevoluteJointDef definition;
  definition.Initialize(robot.body, held.body, toUnits(bodies_[turret.body].pose.position));
  definition.maxMotorTorque = static_cast<float>(bodies_.jointOf(turret).max_effort * kSquareUnits);
  turret.held.heading = held.heading - robot.heading - turret.sense * turret.state.angle;
  return makeJoint<TurretJoint, b2RevoluteJoint>(*world_, definition);
}

void Dynamics2d::readTurrets(double step) {
  for (Turret& turret : bodies_.turrets()) {
    const RigidBody& robot = rigid(turret.body);
    if (const b2RevoluteJoint* motor = motorOf(robot)) {
      const RigidBody& held = rigid(robot.grip.gripped);
      const double turned = held.heading - robot.heading - turret.held.heading;
      const double turn_rate = held.body->GetAngularVelocity() - robot.body->GetAngularVelocity();
      const double torque = motor->GetMotorTorque(static_cast<float>(1.0 / step)) / kSquareUnits;
      turret.state = {wrapTurn(turret.sense * turned), turret.sense * turn_rate, turret.sense * torque};
    }
  }
}

void Dynamics2d::finishTurrets(Space& space) {
  constexpr double kSeen = 1e-4;  // rad: a held angle trembles by less
  for (const Turret& turret : bodies_.turrets()) {
    if (std::abs(wrapTurn(turret.state.angle - bodies_.shapesAngle(turret))) > kSeen) {
      turnGripper(turret);
    }
    space.joints[bodies_[turret.body].row][turret.joint] = turret.state;
  }
}

}  // namespace swarmanoid::dynamics2d
