#include "transmitters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid::devices {
namespace {

/// Distance of a point from a solid; 0 inside it [m]. @param point in B
double distanceTo(const CollisionShape& shape, const Eigen::Vector3d& point) {
  const Eigen::Vector3d inner = shape.orientation.conjugate() * (point - shape.position);
  const Eigen::Vector3d& half = shape.half_extent;
  switch (shape.kind) {
    case CollisionShape::Kind::kCylinder:
      return std::hypot(std::max(0.0, std::hypot(inner.x(), inner.y()) - half.x()),
                        std::max(0.0, std::abs(inner.z()) - half.z()));
    case CollisionShape::Kind::kBox:
      return (inner.cwiseAbs() - half).cwiseMax(0.0).norm();
    case CollisionShape::Kind::kSphere:
      break;
  }
  return std::max(0.0, inner.norm() - half.x());
}

void refuseFarOutside(const EntityModel& model, const char* device, const char* link, const Eigen::Vector3d& position) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const CollisionShape& shape : model.shapes) {
    nearest = std::min(nearest, distanceTo(shape, position));
  }
  if (nearest > kMostOutside) {
    throw ConfigError({}, "found the device '" + std::string(device) + "' on a " + model.type +
                              " whose transmitter (the link " + link + ", or the middle of its height) is " +
                              numberText(nearest) + " m outside of its solids, allowed: at most " +
                              numberText(kMostOutside) + " m");
  }
}

}  // namespace

Transmitter transmitterOf(const EntityModel& model, const char* device, const char* link) {
  Transmitter transmitter{{0.0, 0.0, 0.5 * (model.lowest + model.highest)}, -1};
  if (const auto mount = model.mounts.find(link); mount != model.mounts.end()) {
    transmitter = {mount->second.position, mount->second.joint};
  }
  refuseFarOutside(model, device, link, transmitter.position);
  return transmitter;
}

Eigen::Vector3d positionOf(const Space& space, Row row, const Transmitter& transmitter) {
  const Pose& pose = space.entities.pose[row];
  if (transmitter.joint < 0) {
    return pose.toWorld(transmitter.position);
  }
  const Eigen::Isometry3d displacement =
      displacementOf(*space.entities.model[row], space.joints[row], transmitter.joint);
  return pose.toWorld(displacement * transmitter.position);
}

const Transmitter& Transmitters::of(const EntityModel& model, const char* device, const char* link) {
  auto known =
      std::find_if(known_.begin(), known_.end(), [&](const Known& candidate) { return candidate.model == &model; });
  if (known == known_.end()) {
    known = known_.insert(known_.end(), {&model, transmitterOf(model, device, link)});
  }
  return known->transmitter;
}

}  // namespace swarmanoid::devices
