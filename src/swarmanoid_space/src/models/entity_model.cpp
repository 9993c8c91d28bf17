#include "swarmanoid_space/models/entity_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace swarmanoid {
namespace {

using Eigen::Vector3d;

/// Distance of the shape's farthest point from a point of B [m].
double reachFrom(const Vector3d& point, const CollisionShape& shape) {
  const Vector3d centre =
      (shape.orientation.conjugate() * (shape.position - point)).cwiseAbs();  // in the shape's frame
  const Vector3d& half = shape.half_extent;
  switch (shape.kind) {
    case CollisionShape::Kind::kCylinder:
      return std::hypot(std::hypot(centre.x(), centre.y()) + half.x(), centre.z() + half.z());
    case CollisionShape::Kind::kBox:
      return (centre + half).norm();
    case CollisionShape::Kind::kSphere:
      break;
  }
  return centre.norm() + half.x();
}

/// Distance of the shape's farthest point from body z [m].
double reachFromAxis(const CollisionShape& shape) {
  const Vector3d& half = shape.half_extent;
  const double offset = std::hypot(shape.position.x(), shape.position.y());
  const bool is_upright = std::abs((shape.orientation * Vector3d::UnitZ()).z()) > 1.0 - 1e-9;
  if (shape.kind == CollisionShape::Kind::kSphere || (shape.kind == CollisionShape::Kind::kCylinder && is_upright)) {
    return offset + half.x();
  }
  double reach = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3d signs((corner & 1) != 0 ? 1.0 : -1.0, (corner & 2) != 0 ? 1.0 : -1.0,
                         (corner & 4) != 0 ? 1.0 : -1.0);
    const Vector3d point = shape.position + shape.orientation * half.cwiseProduct(signs);
    reach = std::max(reach, std::hypot(point.x(), point.y()));
  }
  return reach;
}

EntityModel::Silhouette silhouetteOf(const CollisionShape& shape) {
  const double reach = shape.reachAlong(Vector3d::UnitZ());
  const bool is_upright = shape.orientation.x() == 0.0 && shape.orientation.y() == 0.0;
  const bool is_about_z = shape.position.head<2>().isZero(0.0);
  return {reachFromAxis(shape), shape.position.z() - reach, shape.position.z() + reach,
          shape.kind == CollisionShape::Kind::kCylinder && is_upright && is_about_z};
}

/// Returns whether all joints of the shape turn it about body z.
bool turnsAboutBodyZ(const EntityModel& model, const CollisionShape& shape) {
  for (int joint = shape.joint; joint >= 0; joint = model.joints[static_cast<std::size_t>(joint)].carrier) {
    const EntityModel::Joint& turning = model.joints[static_cast<std::size_t>(joint)];
    if (!turning.frame.position.head<2>().isZero(0.0) || !turning.axis.head<2>().isZero(0.0)) {
      return false;
    }
  }
  return true;
}

/// Upper bound of the distance of a turned shape's points from the body's origin, with the chain of links stretched out
/// [m].
double stretchedReach(const EntityModel& model, const CollisionShape& shape) {
  const EntityModel::Joint* turning = &model.joints[static_cast<std::size_t>(shape.joint)];
  double reach = reachFrom(turning->frame.position, shape);
  while (turning->carrier >= 0) {
    const EntityModel::Joint* carrier = &model.joints[static_cast<std::size_t>(turning->carrier)];
    reach += (turning->frame.position - carrier->frame.position).norm();
    turning = carrier;
  }
  return reach + turning->frame.position.norm();
}

}  // namespace

double CollisionShape::reachAlong(const Vector3d& direction) const {
  const Vector3d along = orientation.conjugate() * direction;  // in the shape's frame
  switch (kind) {
    case Kind::kCylinder:
      return half_extent.x() * std::hypot(along.x(), along.y()) + half_extent.z() * std::abs(along.z());
    case Kind::kBox:
      return half_extent.dot(along.cwiseAbs());
    case Kind::kSphere:
      break;
  }
  return half_extent.x();
}

void EntityModel::measureShapes() {
  lowest = 0.0;
  highest = 0.0;
  bounding_radius = 0.0;
  horizontal_radius = 0.0;
  silhouettes.clear();
  if (!shapes.empty()) {
    lowest = std::numeric_limits<double>::infinity();
    highest = -lowest;
  }
  for (const CollisionShape& shape : shapes) {
    const Silhouette silhouette = silhouetteOf(shape);
    lowest = std::min(lowest, silhouette.low);
    highest = std::max(highest, silhouette.high);
    bounding_radius = std::max(bounding_radius, reachFrom(Vector3d::Zero(), shape));
    horizontal_radius = std::max(horizontal_radius, silhouette.radius);
    silhouettes.push_back(silhouette);
  }
  measureTurning();
  measureLeds();
}

void EntityModel::measureLeds() {
  led_bounds = {};
  led_bounds.count = led_positions.size();
  if (led_positions.empty()) {
    return;
  }
  led_bounds.lowest = std::numeric_limits<double>::infinity();
  led_bounds.highest = -led_bounds.lowest;
  for (const Vector3d& led : led_positions) {
    led_bounds.lowest = std::min(led_bounds.lowest, led.z());
    led_bounds.highest = std::max(led_bounds.highest, led.z());
    led_bounds.radius = std::max(led_bounds.radius, led.head<2>().norm());
  }
}

void EntityModel::measureTurning() {
  moving_reach = bounding_radius;
  joints_keep_outline = true;
  if (joints.empty()) {
    return;  // no joint; engines measure shapes that they have turned themselves
  }
  for (const CollisionShape& shape : shapes) {
    if (!turnsAboutBodyZ(*this, shape)) {
      joints_keep_outline = false;
      moving_reach = std::max(moving_reach, stretchedReach(*this, shape));
    }
  }
}

void Inertial::add(const Inertial& part) {
  // moves both inertias to the common centre of mass (parallel axes)
  const auto atDistance = [](double m, const Vector3d& r) -> Eigen::Matrix3d {
    return m * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
  };
  const double total = mass + part.mass;
  if (!(total > 0.0)) {
    return;
  }
  const Vector3d common = (mass * centre_of_mass + part.mass * part.centre_of_mass) / total;
  inertia +=
      part.inertia + atDistance(mass, centre_of_mass - common) + atDistance(part.mass, part.centre_of_mass - common);
  centre_of_mass = common;
  mass = total;
}

void EntityModel::addMass(const Inertial& part) {
  Inertial whole{mass, centre_of_mass, inertia};
  whole.add(part);
  mass = whole.mass;
  centre_of_mass = whole.centre_of_mass;
  inertia = whole.inertia;
}

int EntityModel::findJoint(const std::string& name) const {
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (joints[i].name == name) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

int EntityModel::findHolder(const std::string& holder) const {
  const auto found =
      std::find_if(holders.begin(), holders.end(), [&](const Holder& each) { return each.name == holder; });
  return found == holders.end() ? -1 : static_cast<int>(found - holders.begin());
}

int EntityModel::findProperty(std::string_view property) const {
  const auto found =
      std::find_if(properties.begin(), properties.end(), [&](const Property& each) { return each.name == property; });
  return found == properties.end() ? -1 : static_cast<int>(found - properties.begin());
}

std::string EntityModel::missingPart(const Mechanism& mechanism) const {
  switch (mechanism.kind) {
    case Mechanism::Kind::kWheels:
      return wheels ? "" : "wheels";
    case Mechanism::Kind::kFlight:
      return "";  // every entity with a flight command can fly
    case Mechanism::Kind::kJoint:
      if (mechanism.name.empty()) {
        return joints.empty() ? "joints" : "";
      }
      return findJoint(mechanism.name) >= 0 ? "" : "joint '" + mechanism.name + "'";
    case Mechanism::Kind::kHolder:
      if (mechanism.name.empty()) {
        return holders.empty() ? "holders" : "";
      }
      return findHolder(mechanism.name) >= 0 ? "" : mechanism.name;
  }
  return "";
}

const Mount& EntityModel::mount(const std::string& name) const {
  const auto found = mounts.find(name);
  if (found == mounts.end()) {
    throw std::out_of_range("entity type '" + type + "' has no mount '" + name + "'");
  }
  return found->second;
}

std::shared_ptr<const EntityModel> blockModel(const Vector3d& size, double mass, bool is_ferromagnetic) {
  auto model = std::make_shared<EntityModel>();
  model->type = "block";
  model->title = "Block";
  CollisionShape box;
  box.kind = CollisionShape::Kind::kBox;
  box.half_extent = size / 2.0;
  model->shapes.push_back(box);
  model->measureShapes();
  model->is_movable = mass > 0.0;
  model->is_ferromagnetic = is_ferromagnetic;
  model->origin_height = size.z() / 2.0;
  const Vector3d square = size.cwiseProduct(size) / 12.0;
  const Vector3d moments(square.y() + square.z(), square.x() + square.z(), square.x() + square.y());
  model->addMass({mass, Vector3d::Zero(), mass * moments.asDiagonal().toDenseMatrix()});
  return model;
}

std::shared_ptr<const EntityModel> cylindricPreyModel(double radius, double height, double mass) {
  auto model = std::make_shared<EntityModel>();
  model->type = "cylindric_prey";
  model->title = "CylindricPrey";  // one word, because tools split the text table at white space
  const Vector3d middle(0.0, 0.0, height / 2.0);
  CollisionShape cylinder;
  cylinder.half_extent = {radius, radius, height / 2.0};
  cylinder.position = middle;
  model->shapes.push_back(cylinder);
  model->is_movable = true;
  model->gripping_radius = radius;
  model->led_positions.push_back(middle);
  model->measureShapes();
  const double across = radius * radius / 4.0 + height * height / 12.0;
  const Vector3d moments(across, across, radius * radius / 2.0);
  model->addMass({mass, middle, mass * moments.asDiagonal().toDenseMatrix()});
  return model;
}

std::shared_ptr<const EntityModel> lightModel(double intensity) {
  auto model = std::make_shared<EntityModel>();
  model->type = "light";
  model->title = "Light";
  model->led_positions.push_back(Vector3d::Zero());
  model->measureShapes();
  model->properties.push_back(
      {kIntensity, "", "Times the brightness of an LED of its colour; at 0 it is dark.", kIntensityRange, intensity});
  return model;
}

}  // namespace swarmanoid
