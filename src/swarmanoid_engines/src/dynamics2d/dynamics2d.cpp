// Changes of the engine between ticks: parameters, entities and their poses.
#include "dynamics2d/dynamics2d.hpp"

#include <algorithm>
#include <cmath>

#include "common/parameter.hpp"
#include "swarmanoid_space/models/limits.hpp"

namespace swarmanoid::dynamics2d {
namespace {

constexpr Range kIterationsRange{1.0, 1000.0};

std::vector<Parameter> materialParameters() {
  const Material standard;
  return {
      makeParameter(
          "iterations", Parameter::Type::kInteger, "", std::to_string(standard.iterations), kIterationsRange,
          "Maximum number of iterations of the contact solver in each step; it stops earlier when it has converged."),
      makeNumber("gravity", "m/s2", standard.gravity, limits::kGravity, "Presses bodies on the plane."),
      makeNumber("ground_friction", "", standard.ground_friction, limits::kFriction,
                 "Coefficient of bodies that slide on the plane."),
      makeNumber("treel_friction", "", standard.treel_friction, limits::kFriction,
                 "Coefficient of treels on the plane: beyond it they slip."),
      makeNumber("contact_friction", "", standard.contact_friction, limits::kFriction, "Coefficient between bodies."),
      makeNumber("restitution", "", standard.restitution, limits::kRestitution,
                 "Part of the speed that bodies bounce back with."),
      makeNumber("grip_strength", "N", standard.grip_strength, limits::kStrength, "A grip tears beyond this force.")};
}

Material readMaterial(const Configuration& parameters) {
  const Material standard;
  Material result;
  result.iterations =
      static_cast<int>(parameters.integer("iterations", std::int64_t{standard.iterations}, kIterationsRange));
  result.gravity = parameters.number("gravity", standard.gravity, limits::kGravity);
  result.ground_friction = parameters.number("ground_friction", standard.ground_friction, limits::kFriction);
  result.treel_friction = parameters.number("treel_friction", standard.treel_friction, limits::kFriction);
  result.contact_friction = parameters.number("contact_friction", standard.contact_friction, limits::kFriction);
  result.restitution = parameters.number("restitution", standard.restitution, limits::kRestitution);
  const std::string support = parameters.text("support", "even");
  if (support != "even" && support != "edge") {
    throw ConfigError(parameters.location(), "support: found '" + support + "', allowed: even, edge");
  }
  result.pressure = support == "even" ? Pressure::kEven : Pressure::kEdge;
  result.grip_strength = parameters.number("grip_strength", standard.grip_strength, limits::kStrength);
  return result;
}

/// Reason why a model is not supported, or "": shapes need an extent, and movable entities mass and inertia.
std::string problemWithModel(const EntityModel& model) {
  if (model.is_movable && !(model.mass > 0.0 && model.inertia.diagonal().minCoeff() > 0.0)) {
    return "has no mass or no inertia, so forces cannot move it";
  }
  for (const CollisionShape& shape : model.shapes) {
    if (shape.half_extent.minCoeff() < 0.5 * kThinnest) {
      return "has a shape thinner than 1 mm, which this engine cannot hold";
    }
  }
  return "";
}

}  // namespace

PluginDescription Dynamics2d::describe() {
  PluginDescription description;
  description.label = "dynamics2d";
  description.summary = "Two-dimensional rigid bodies on Box2D: masses, friction, force-limited drives, any grips.";
  description.parameters = placementParameters();
  for (const Parameter& own : materialParameters()) {
    description.parameters.push_back(live(own));
  }
  Parameter support =
      makeParameter("support", Parameter::Type::kChoice, "", "even", {},
                    "Where sliding bodies carry their weight: evenly on their outline, or on its edge.");
  support.choices = {"even", "edge"};
  description.parameters.push_back(support);
  return description;
}

void Dynamics2d::configure(const std::string& id, const Configuration& parameters) {
  PlanarEngine::configure(id, parameters);
  material_ = readMaterial(parameters);
}

void Dynamics2d::reconfigure(const Configuration& parameters) { material_ = readMaterial(parameters); }

std::string Dynamics2d::unsupportedReason(const EntityModel& model, const std::vector<DeviceUse>& devices) const {
  const std::string problem = PlanarEngine::unsupportedReason(model, devices);
  return problem.empty() ? problemWithModel(model) : problem;
}

void Dynamics2d::add(const Space& space, Row row, Role role) {
  const BodyIndex index = bodies_.add(space, row, role);
  rigid_bodies_.resize(std::max(rigid_bodies_.size(), static_cast<std::size_t>(index) + 1));
  rigid(index) = RigidBody{};
  measureMass(index);
  takeMotion(space, index);
  travelled_ += kLookAhead;  // all bodies search their surroundings anew
  if (role == Role::kMove && bodies_[index].is_movable) {
    const auto older = [&](BodyIndex a, BodyIndex b) { return bodies_[a].number < bodies_[b].number; };
    movers_.insert(std::upper_bound(movers_.begin(), movers_.end(), index, older), index);
  }
  takeOverGrips(space, index);
}

/// Mass properties of a body that this engine moves; other bodies turn about their origin.
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

void Dynamics2d::takeMotion(const Space& space, BodyIndex index) {
  const Body& body = bodies_[index];
  RigidBody& rigid_body = rigid(index);
  const planar::Plane& plane = bodies_.plane();
  rigid_body.heading = body.pose.heading;
  rigid_body.centre = body.pose.position + body.pose.rotated(rigid_body.arm);
  const Twist& twist = space.entities.twist[body.row];
  const Eigen::Vector2d arm = body.pose.rotated(rigid_body.arm);
  rigid_body.spin = plane.along(twist.angular);
  // a mirror moves straight to the end of its entity's arc
  const Eigen::Vector3d linear =
      body.role == Role::kMirror ? meanVelocity(twist, toSeconds(space.clocktick)) : twist.linear;
  rigid_body.velocity = plane.toLocal(linear) + rigid_body.spin * Eigen::Vector2d(-arm.y(), arm.x());
}

/// Drops the contact shapes and the support of a body whose shapes have changed.
void Dynamics2d::forgetShapes(BodyIndex index) {
  rigid(index).shapes.clear();
  rigid(index).support.points.clear();
}

void Dynamics2d::takePose(const Space& space, BodyIndex index) {
  if (bodies_.place(space, index)) {
    measureMass(index);
    forgetShapes(index);
  }
  takeMotion(space, index);
}

void Dynamics2d::remove(const Space&, Row row) {
  const BodyIndex index = bodies_.find(row);
  forgetGrips(index);
  rigid(index) = RigidBody{};
  for (std::vector<BodyIndex>* list : {&movers_, &present_, &mirrors_}) {
    list->erase(std::remove(list->begin(), list->end(), index), list->end());
  }
  contacts_.clear();
  bodies_.remove(index);
}

void Dynamics2d::place(const Space& space, Row row) {
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
  contacts_.clear();
  crowd_memory_.clear();
  travelled_ = 0.0;
}

}  // namespace swarmanoid::dynamics2d

REGISTER_ENGINE(swarmanoid::dynamics2d::Dynamics2d)
