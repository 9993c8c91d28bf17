#include "planar/planar_engine.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "common/parameter.hpp"
#include "common/turret.hpp"
#include "common/unsupported_mechanisms.hpp"
#include "planar/body_overlap.hpp"
#include "planar/body_rays.hpp"
#include "planar/draw_bodies.hpp"
#include "swarmanoid_interface/expects.hpp"
#include "swarmanoid_interface/plain_text.hpp"
#include "swarmanoid_space/models/limits.hpp"

namespace swarmanoid::planar {
namespace {
constexpr Range kSubclockRange{1.0, 10000.0};

/// Whether a device needs a joint or holder that works in three dimensions only.
bool isSpatial(const EntityModel& model, const DeviceUse& device) {
  const int turret = turretJoint(model);
  const EntityModel::Joint* planar = turret < 0 ? nullptr : &model.joints[static_cast<std::size_t>(turret)];
  return std::any_of(model.joints.begin(), model.joints.end(),
                     [&](const EntityModel::Joint& joint) {
                       return &joint != planar && worksWith(device, Mechanism::Kind::kJoint, joint.name);
                     }) ||
         std::any_of(model.holders.begin(), model.holders.end(), [&](const EntityModel::Holder& holder) {
           return holder.kind != EntityModel::Holder::Kind::kGripper &&
                  worksWith(device, Mechanism::Kind::kHolder, holder.name);
         });
}

}  // namespace

std::vector<Parameter> PlanarEngine::placementParameters() {
  using Type = Parameter::Type;
  Parameter axis = makeParameter("perpendicular_axis", Type::kChoice, "", "z", {},
                                 "The axis that the engine's plane is perpendicular to.");
  axis.choices = {"x", "y", "z"};
  return {makeParameter("subclock", Type::kInteger, "", "1", kSubclockRange, "Steps of the engine in each tick."), axis,
          makeParameter("distance", Type::kNumber, "m", "0", limits::kCoordinate,
                        "Signed distance of the plane from the origin.")};
}

void PlanarEngine::configure(const std::string& id, const Configuration& parameters) {
  id_ = id;
  subclock_ = static_cast<int>(parameters.integer("subclock", std::int64_t{1}, kSubclockRange));
  const std::string axis = parameters.text("perpendicular_axis", "z");
  if (axis != "x" && axis != "y" && axis != "z") {
    throw ConfigError(parameters.location(), "perpendicular_axis: found '" + axis + "', allowed: x, y, z");
  }
  bodies_.configure(Plane(axis[0], parameters.number("distance", 0.0, limits::kCoordinate)));
}

std::string PlanarEngine::unsupportedReason(const EntityModel& model, const std::vector<DeviceUse>& devices) const {
  std::string problem = unsupportedMechanismsReason(model, devices);
  if (!problem.empty()) {
    return problem;
  }
  const auto spatial =
      std::find_if(devices.begin(), devices.end(), [&](const DeviceUse& device) { return isSpatial(model, device); });
  return spatial == devices.end() ? "" : "device '" + spatial->type + "' cannot be simulated in a plane";
}

bool PlanarEngine::mayStandIdle(const EntityModel& model, const DeviceUse& device) const {
  return isSpatial(model, device);
}

std::string PlanarEngine::unsupportedStateReason(const Space& space, Row row) const {
  constexpr double kStretched = 0.02;  // rad
  const EntityModel& model = *space.entities.model[row];
  const int turret = turretJoint(model);
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    // arms are idle in a plane; the engine uses their mass distribution with the joints at zero
    if (static_cast<int>(i) != turret && std::abs(space.joints[row][i].angle) > kStretched) {
      return "its joint '" + model.joints[i].name + "' is not at zero";
    }
  }
  return unsupportedAttachmentReason(space, row);
}

std::string PlanarEngine::invalidPoseReason(const EntityModel& model, const Pose& pose) const {
  constexpr double kInPlane = 1e-6;  // m
  const Plane& plane = bodies_.plane();
  const double along = plane.along(pose.position);
  // a model with its origin above its base stands on the plane
  const double height = model.origin_height * plane.along(pose.orientation * Eigen::Vector3d::UnitZ());
  if (model.is_movable && std::abs(along - height - plane.distance()) > kInPlane) {
    PlainTextStream text;
    text << "found at " << plane.axisName() << " = " << along << ", allowed: in the engine's plane, "
         << plane.axisName() << " = " << plane.distance() + height;
    return text.str();
  }
  if (model.wheels && !plane.isUpright(pose.orientation)) {
    return "found tilted, allowed: standing on its treels, its z axis along " + plane.axisName();
  }
  return "";
}

Row PlanarEngine::overlap(const EntityModel& model, const Pose& pose, Span<const Row> ignored) const {
  const BodyIndex found = findOverlap(bodies_, model, pose, ignored);
  return found == kNoBody ? kNoRow : bodies_[found].row;
}

bool PlanarEngine::mayHit(const RayBundle& rays) const { return planar::mayHit(bodies_, rays); }

void PlanarEngine::findObstacles(const RayBundle& rays, Obstacles& found) const {
  if (hitsPrisms()) {
    Engine::findObstacles(rays, found);  // outlines in the plane do not show the view from above
  } else {
    planar::findObstacles(*this, bodies_, rays, found);
  }
}

void PlanarEngine::raycast(const RayBundle& rays, Span<RayHit> hits) const { planar::raycast(bodies_, rays, hits); }

void PlanarEngine::castRayAt(const Obstacles::Solid& solid, const Segment& segment, RayHit& hit) const {
  planar::castRayAt(bodies_, solid, segment, hit);
}

bool PlanarEngine::hitsPrisms() const { return bodies_.plane().normal() != Eigen::Vector3d::UnitZ(); }

bool PlanarEngine::blocks(Row row, const RayBundle& ray) const {
  SWARMANOID_EXPECTS(bodies_.find(row) != kNoBody);
  return planar::isHit(bodies_, ray.segments[0], bodies_.find(row));
}

void PlanarEngine::draw(EngineDrawing& drawing) const { drawShapes(bodies_, drawing); }

}  // namespace swarmanoid::planar
