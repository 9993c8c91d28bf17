// What the engine is told between ticks.
#include "kinematics2d/kinematics2d.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "planar/planar_overlap.hpp"

namespace swarmanoid::kinematics2d {
namespace {
constexpr Range kSubclockRange{1.0, 10000.0};
}

PluginDescription Kinematics2d::describe() {
  PluginDescription description;
  description.label = "kinematics2d";
  description.label_aliases = {"dummy_engine"};
  description.summary = "Two-dimensional kinematics: velocities, collisions, gripping of preys; no masses, no forces.";
  Parameter subclock;
  subclock.name = "subclock";
  subclock.type = Parameter::Type::kInteger;
  subclock.value = "1";
  subclock.range = kSubclockRange;
  subclock.description = "Steps of the engine in each tick.";
  Parameter axis;
  axis.name = "perpendicular_axis";
  axis.type = Parameter::Type::kChoice;
  axis.value = "z";
  axis.choices = {"x", "y", "z"};
  axis.description = "The axis that the engine's plane is perpendicular to.";
  Parameter distance;
  distance.name = "distance";
  distance.type = Parameter::Type::kNumber;
  distance.unit = "m";
  distance.value = "0";
  distance.description = "Signed distance of the plane from the origin.";
  description.parameters = {subclock, axis, distance};
  return description;
}

void Kinematics2d::configure(const std::string& id, const Configuration& parameters) {
  id_ = id;
  subclock_ = static_cast<int>(parameters.integer("subclock", std::int64_t{1}, kSubclockRange));
  const std::string axis = parameters.text("perpendicular_axis", "z");
  if (axis != "x" && axis != "y" && axis != "z") {
    throw ConfigError(parameters.location(), "perpendicular_axis: found '" + axis + "', allowed: x, y, z");
  }
  bodies_.configure(planar::Plane(axis[0], parameters.number("distance", 0.0)));
}

std::string Kinematics2d::refusal(const EntityModel& model, const std::vector<std::string>& devices) const {
  if (model.shapes.empty()) {
    return "has no shape, so this engine has nothing to hold";
  }
  const auto lacks = [](const std::string& device, const char* part) {
    return "device '" + device + "' cannot be simulated: a robot of this type has no " + part;
  };
  bool is_driven = false;
  for (const std::string& device : devices) {
    if (device == FootbotWheels::kType && !model.wheels) {
      return lacks(device, "wheels");
    }
    if (device == FootbotGripper::kType && !model.gripper) {
      return lacks(device, "gripper");
    }
    const bool is_drive = device == FootbotWheels::kType || device == EyebotVelocity::kType;
    if (is_drive && is_driven) {
      return "device '" + device + "' cannot be simulated: another device drives the robot already";
    }
    is_driven = is_driven || is_drive;
  }
  return "";
}

std::string Kinematics2d::misplacement(const EntityModel& model, const Pose& pose) const {
  constexpr double kInPlane = 1e-6;  // m
  const planar::Plane& plane = bodies_.plane();
  const double along = plane.along(pose.position);
  // what has its origin above its base stands on the plane
  const double height = model.origin_height * plane.along(pose.orientation * Eigen::Vector3d::UnitZ());
  if (!model.is_movable || std::abs(along - height - plane.distance()) <= kInPlane) {
    return "";
  }
  std::ostringstream text;
  text << "found at " << plane.axisName() << " = " << along << ", allowed: in the engine's plane, " << plane.axisName()
       << " = " << plane.distance() + height;
  return text.str();
}

Row Kinematics2d::overlap(const EntityModel& model, const Pose& pose, Span<const Row> ignored) const {
  const planar::Plane& plane = bodies_.plane();
  PlanarModel projected;
  planar::projectModel(model, plane, plane.baseOf(pose.orientation), projected);
  const PlacedPose placed = PlacedPose::at(plane.toLocal(pose.position), plane.headingOf(pose.orientation));
  const double along = plane.along(pose.position);
  std::vector<PlanarShape> scratch;
  BodyIndex found = kNoBody;
  bodies_.visitNear(placed.position, projected.radius, [&](BodyIndex index) {
    const Body& body = bodies_[index];
    const bool is_older = found == kNoBody || body.number < bodies_[found].number;
    const bool is_ignored = std::find(ignored.begin(), ignored.end(), body.row) != ignored.end();
    if (!is_ignored && is_older && modelsOverlap(projected, placed, along, body, scratch)) {
      found = index;
    }
    return true;
  });
  return found == kNoBody ? kNoRow : bodies_[found].row;
}

void Kinematics2d::add(Space& space, Row row, Role role) {
  takeOverGrips(space, bodies_.add(space, row, role));
  is_somebody_new_ = true;
}

void Kinematics2d::remove(Space&, Row row) {
  const BodyIndex index = bodies_.find(row);
  forgetGrips(index);
  bodies_.remove(index);
}

void Kinematics2d::place(Space& space, Row row) {
  const BodyIndex index = bodies_.find(row);
  forgetGrips(index);
  bodies_.place(space, index);
  is_somebody_new_ = true;
}

}  // namespace swarmanoid::kinematics2d

REGISTER_ENGINE(swarmanoid::kinematics2d::Kinematics2d)
