// What changes in the engine between ticks: parameters, entities and their poses.
#include "dynamics2d/dynamics2d.hpp"

#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>

#include <algorithm>
#include <cmath>

#include "common/parameter.hpp"
#include "common/turret.hpp"
#include "dynamics2d/fixtures.hpp"
#include "swarmanoid_space/models/limits.hpp"

namespace swarmanoid::dynamics2d {
namespace {

constexpr Range kFrictionRange{0.0, 10.0};
constexpr Range kFractionRange{0.0, 1.0};
constexpr Range kIterationsRange{1.0, 1000.0};

std::vector<Parameter> materialParameters() {
  const Material standard;
  return {
      makeParameter("iterations", Parameter::Type::kInteger, "", std::to_string(standard.iterations), kIterationsRange,
                    "Of the solver of contacts and joints, in each step."),
      makeNumber("gravity", "m/s2", standard.gravity, limits::kGravity, "Presses bodies on the plane."),
      makeNumber("ground_friction", "", standard.ground_friction, kFrictionRange,
                 "Coefficient of what slides on the plane."),
      makeNumber("treel_friction", "", standard.treel_friction, kFrictionRange,
                 "Coefficient of treels on the plane: beyond it they slip."),
      makeNumber("contact_friction", "", standard.contact_friction, kFrictionRange, "Coefficient between bodies."),
      makeNumber("restitution", "", standard.restitution, kFractionRange,
                 "Part of the speed that bodies bounce back with."),
      makeNumber("grip_strength", "N", standard.grip_strength, limits::kStrength, "A grip tears beyond this force.")};
}

Material readMaterial(const Configuration& parameters) {
  const Material standard;
  Material result;
  result.iterations =
      static_cast<int>(parameters.integer("iterations", std::int64_t{standard.iterations}, kIterationsRange));
  result.gravity = parameters.number("gravity", standard.gravity, limits::kGravity);
  result.ground_friction = parameters.number("ground_friction", standard.ground_friction, kFrictionRange);
  result.treel_friction = parameters.number("treel_friction", standard.treel_friction, kFrictionRange);
  result.contact_friction = parameters.number("contact_friction", standard.contact_friction, kFrictionRange);
  result.restitution = parameters.number("restitution", standard.restitution, kFractionRange);
  result.grip_strength = parameters.number("grip_strength", standard.grip_strength, limits::kStrength);
  return result;
}

/// Box2D cannot hold shapes without extent, and integrates nothing without mass.
std::string problemWithModel(const EntityModel& model) {
  if (model.is_movable && !(model.mass > 0.0 && model.inertia.diagonal().minCoeff() > 0.0)) {
    return "has no mass or no inertia, so forces cannot move it";
  }
  for (const CollisionShape& shape : model.shapes) {
    if (shape.half_extent.minCoeff() < 0.5 * kThinnest) {
      return "has a shape thinner than 1 mm, which Box2D cannot hold";
    }
  }
  return "";
}

/// Such a cylinder has more corners than Box2D's polygons, and what is made of several cannot be turned.
bool turnsLyingCylinder(const EntityModel& model) {
  const int turret = turretJoint(model);
  return std::any_of(model.shapes.begin(), model.shapes.end(), [&](const CollisionShape& shape) {
    const bool is_upright = std::abs((shape.orientation * Eigen::Vector3d::UnitZ()).z()) > 1.0 - 1e-9;
    return turret >= 0 && shape.joint == turret && shape.kind == CollisionShape::Kind::kCylinder && !is_upright;
  });
}

}  // namespace

Dynamics2d::Dynamics2d() { makeWorld(); }

PluginDescription Dynamics2d::describe() {
  PluginDescription description;
  description.label = "dynamics2d";
  description.summary = "Two-dimensional rigid bodies on Box2D: masses, friction, force-limited drives, any grips.";
  description.parameters = placementParameters();
  for (const Parameter& own : materialParameters()) {
    description.parameters.push_back(live(own));
  }
  return description;
}

void Dynamics2d::configure(const std::string& id, const Configuration& parameters) {
  PlanarEngine::configure(id, parameters);
  material_ = readMaterial(parameters);
}

void Dynamics2d::reconfigure(const Configuration& parameters) {
  material_ = readMaterial(parameters);
  for (const BodyIndex index : bodies_.order()) {
    if (rigid(index).isAlone()) {
      continue;
    }
    for (b2Fixture* fixture = rigid(index).body->GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext()) {
      fixture->SetFriction(static_cast<float>(material_.contact_friction));
      fixture->SetRestitution(static_cast<float>(material_.restitution));
    }
    dropBelt(rigid(index));  // the next tick makes another
  }
  for (b2Contact* contact = world_->GetContactList(); contact != nullptr; contact = contact->GetNext()) {
    contact->ResetFriction();
    contact->ResetRestitution();
  }
  for (const BodyIndex index : movers_) {
    setGroundFriction(index);
  }
}

std::string Dynamics2d::unsupportedReason(const EntityModel& model, const std::vector<DeviceUse>& devices) const {
  std::string problem = PlanarEngine::unsupportedReason(model, devices);
  if (problem.empty() && turnsLyingCylinder(model)) {
    return "has a cylinder on its turret that does not stand upright, which this engine cannot turn";
  }
  return problem.empty() ? problemWithModel(model) : problem;
}

std::string Dynamics2d::invalidPoseReason(const EntityModel& model, const Pose& pose) const {
  const double farthest = bodies_.plane().toLocal(pose.position).cwiseAbs().maxCoeff();
  if (farthest > limits::kFarthestInSinglePrecision) {
    return "found at " + numberText(farthest) + " m from the origin, allowed: at most " +
           numberText(limits::kFarthestInSinglePrecision) + " m along each axis, since Box2D has single precision";
  }
  return PlanarEngine::invalidPoseReason(model, pose);
}

void Dynamics2d::makeWorld() {
  world_ = std::make_unique<b2World>(b2Vec2(0.0F, 0.0F));
  world_->SetContactFilter(&contacts_);
  world_->SetContactListener(&contacts_);
  // a sleeping body would forget its last bit of speed, and sleep depends on more than the state that is handed over
  world_->SetAllowSleeping(false);
  const b2BodyDef ground;
  ground_ = world_->CreateBody(&ground);
}

void Dynamics2d::add(Space& space, Row row, Role role) {
  const BodyIndex index = bodies_.add(space, row, role);
  rigid_bodies_.resize(std::max(rigid_bodies_.size(), static_cast<std::size_t>(index) + 1));
  rigid(index) = RigidBody{};
  measureMass(index);
  putBody(space, index);
  travelled_ += kLookAhead;  // all bodies search their surroundings anew
  if (role == Role::kMove && bodies_[index].is_movable) {
    const auto older = [&](BodyIndex a, BodyIndex b) { return bodies_[a].number < bodies_[b].number; };
    movers_.insert(std::upper_bound(movers_.begin(), movers_.end(), index, older), index);
  } else {
    makeBody(index);  // movers have none as long as they are alone
  }
  takeOverGrips(space, index);
}

void Dynamics2d::makeBody(BodyIndex index) {
  const Body& body = bodies_[index];
  RigidBody& rigid_body = rigid(index);
  b2BodyDef definition;
  definition.userData.pointer = static_cast<uintptr_t>(index);
  if (body.is_movable) {
    definition.type = body.role == Role::kMove ? b2_dynamicBody : b2_kinematicBody;
    definition.bullet = body.role == Role::kMove;  // or Box2D would look for impacts with what stands only
  }
  const planar::PlacedPose pose = rigid_body.pose();
  definition.position = toUnits(pose.position);
  definition.angle = static_cast<float>(pose.heading);
  rigid_body.body = world_->CreateBody(&definition);
  makeFixtures(index);
  rigid_body.writeTransform();
  rigid_body.setVelocity(rigid_body.velocity, rigid_body.spin);
}

void Dynamics2d::makeFixtures(BodyIndex index) {
  const RigidBody& rigid_body = rigid(index);
  b2Body& body = *rigid_body.body;
  while (body.GetFixtureList() != nullptr) {
    body.DestroyFixture(body.GetFixtureList());
  }
  addFixtures(body, *bodies_[index].model, static_cast<float>(material_.contact_friction),
              static_cast<float>(material_.restitution));
  if (body.GetType() == b2_dynamicBody) {
    b2MassData mass;
    mass.mass = static_cast<float>(rigid_body.mass);
    mass.center = toUnits(rigid_body.arm);
    mass.I = static_cast<float>((rigid_body.inertia + rigid_body.mass * rigid_body.arm.squaredNorm()) * kSquareUnits);
    body.SetMassData(&mass);
  }
}

/// Of what is moved here; what is not turns about its origin.
void Dynamics2d::measureMass(BodyIndex index) {
  const Body& body = bodies_[index];
  RigidBody& rigid_body = rigid(index);
  if (!body.is_movable || body.role != Role::kMove) {
    return;
  }
  const planar::Plane& plane = bodies_.plane();
  const Eigen::Matrix3d base = bodies_.details(index).base.toRotationMatrix();
  rigid_body.mass = body.entity->mass;
  rigid_body.inertia = plane.along(base * body.entity->inertia * base.transpose() * plane.normal());
  rigid_body.arm = plane.toLocal(base * body.entity->centre_of_mass);
}

void Dynamics2d::putBody(const Space& space, BodyIndex index) {
  const Body& body = bodies_[index];
  RigidBody& rigid_body = rigid(index);
  const planar::Plane& plane = bodies_.plane();
  rigid_body.heading = body.pose.heading;
  rigid_body.centre = body.pose.position + body.pose.rotated(rigid_body.arm);
  rigid_body.writeTransform();
  const Twist& twist = space.entities.twist[body.row];
  const double turn_rate = plane.along(twist.angular);
  const Eigen::Vector2d arm = body.pose.rotated(rigid_body.arm);
  // a mirror goes straight to where its entity's arc leads
  const Eigen::Vector3d linear =
      body.role == Role::kMirror ? meanVelocity(twist, toSeconds(space.clocktick)) : twist.linear;
  const Eigen::Vector2d velocity = plane.toLocal(linear) + turn_rate * Eigen::Vector2d(-arm.y(), arm.x());
  rigid_body.setVelocity(velocity, turn_rate);
}

void Dynamics2d::takePose(const Space& space, BodyIndex index) {
  const double along = bodies_[index].along;
  const bool is_alone = rigid(index).isAlone();
  if (bodies_.place(space, index)) {
    measureMass(index);
    if (!is_alone) {
      makeFixtures(index);
    }
  } else if (!is_alone && bodies_[index].along != along) {
    for (b2Fixture* fixture = rigid(index).body->GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext()) {
      fixture->Refilter();  // at another height it may pass over others, or no longer
    }
  }
  putBody(space, index);
}

void Dynamics2d::remove(Space&, Row row) {
  const BodyIndex index = bodies_.find(row);
  forgetGrips(index);
  dropBelt(rigid(index));
  if (!rigid(index).isAlone()) {
    world_->DestroyBody(rigid(index).body);
  }
  rigid(index) = RigidBody{};
  for (std::vector<BodyIndex>* list : {&movers_, &present_, &mirrors_}) {
    list->erase(std::remove(list->begin(), list->end(), index), list->end());
  }
  bodies_.remove(index);
}

void Dynamics2d::place(Space& space, Row row) {
  const BodyIndex index = bodies_.find(row);
  forgetGrips(index);
  takePose(space, index);
  travelled_ += kLookAhead;  // all bodies search their surroundings anew
}

void Dynamics2d::clear() {
  bodies_.clear();
  rigid_bodies_.clear();
  movers_.clear();
  present_.clear();
  mirrors_.clear();
  grippers_.clear();
  travelled_ = 0.0;
  makeWorld();
}

}  // namespace swarmanoid::dynamics2d

REGISTER_ENGINE(swarmanoid::dynamics2d::Dynamics2d)
