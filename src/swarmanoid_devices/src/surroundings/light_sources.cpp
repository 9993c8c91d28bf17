#include "light_sources.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "light_cone.hpp"
#include "near_obstacles.hpp"
#include "swarmanoid_interface/devices/light.hpp"
#include "swarmanoid_space/index/positional_index_visits.hpp"

namespace swarmanoid::devices {

/// The lit LEDs of one entity, or the light of one lamp.
struct LightSearch::Lights {
  Row owner = kNoRow;
  LedPoints points;
  std::array<double, LedSet{}.size()> brightness;  // of the lit LEDs
  LedSet lit;
  Eigen::AlignedBox3d box;  // around the lit LEDs, in W [m]
  LightCone cone;
  double reach = 0.0;  // m

  Lights(const Space& space, Row row, const IlluminatedRing& ring);
  double radiusFromAbove() const;
  RayBundle bundleFrom(const IlluminatedRing& ring) const;
  bool areBehind(const IlluminatedSensor& sensor) const;
  bool areAllBefore(const IlluminatedSensor& sensor) const;
  LedSet before(const IlluminatedSensor& sensor) const;
};

LightSearch::Lights::Lights(const Space& space, Row row, const IlluminatedRing& ring)
    : owner(row),
      points(*space.entities.model[row], space.entities.pose[row]),
      cone(lightConeOf(space, row)),
      reach(reachOfLight(*space.entities.model[row], ring.reach)) {
  const EntityModel& model = *space.entities.model[row];
  const Span<const Color> leds = space.leds[row];
  const double intensity = model.is_robot ? 1.0 : space.property(row, kIntensity).value_or(1.0);
  for (std::size_t k = 0; k < points.count; ++k) {
    const Color color = model.is_robot ? leds[k] : space.entities.color[row];
    if (color.isLit() && intensity > 0.0) {
      lit[k] = true;
      brightness[k] = intensity * ring.response.brightness(color);
      box.extend(points[k]);
    }
  }
}

/// Maximum horizontal distance of the lights from the centre of their box [m].
double LightSearch::Lights::radiusFromAbove() const {
  const Eigen::Vector3d middle = box.center();
  double squared = 0.0;
  visitLeds(lit, [&](std::size_t k) { squared = std::max(squared, (points[k] - middle).head<2>().squaredNorm()); });
  return std::sqrt(squared);
}

/// A bundle without segments whose sphere contains all rays from the ring to the lights.
RayBundle LightSearch::Lights::bundleFrom(const IlluminatedRing& ring) const {
  const Eigen::Vector3d half = Eigen::Vector3d::Constant(ring.radius);
  const Eigen::AlignedBox3d both = box.merged({ring.centre - half, ring.centre + half});
  RayBundle rays;
  rays.centre = both.center();
  rays.radius = 0.5 * both.diagonal().norm();
  rays.ignored = ring.self;
  rays.also_ignored = owner;
  return rays;
}

namespace {

Eigen::Vector3d inBody(const Pose& pose, const Eigen::Vector3d& point) {
  return pose.orientation.conjugate() * (point - pose.position);
}

/// The sensors in the frame of the body that carries the lights.
LedShades::Eyes eyesOf(const IlluminatedRing& ring, const Pose& pose) {
  const Eigen::Vector3d centre = inBody(pose, ring.centre);
  LedShades::Eyes eyes{centre.head<2>(), ring.radius, centre.z() - ring.radius, centre.z() + ring.radius};
  if (pose.isUpright()) {
    // upright: all sensors of a level ring have the same height
    eyes.lowest = std::max(eyes.lowest, ring.lowest - pose.position.z());
    eyes.highest = std::min(eyes.highest, ring.highest - pose.position.z());
  }
  return eyes;
}

constexpr double kRounding = 1e-9;  // m

}  // namespace

/// Whether all lights are behind a sensor, as for half of a ring's sensors.
bool LightSearch::Lights::areBehind(const IlluminatedSensor& sensor) const {
  const Eigen::Vector3d half = 0.5 * box.sizes();
  return sensor.direction.dot(box.center() - sensor.position) + sensor.direction.cwiseAbs().dot(half) < -kRounding;
}

/// Whether all lights are certainly before the sensor and within its range, as for most sensors that face them.
bool LightSearch::Lights::areAllBefore(const IlluminatedSensor& sensor) const {
  const Eigen::Vector3d half = 0.5 * box.sizes();
  const Eigen::Vector3d way = box.center() - sensor.position;
  return sensor.direction.dot(way) - sensor.direction.cwiseAbs().dot(half) > kRounding &&
         (way.cwiseAbs() + half).squaredNorm() < reach * reach - kRounding;
}

/// The lit lights that are before the sensor and within its range.
LedSet LightSearch::Lights::before(const IlluminatedSensor& sensor) const {
  if (areAllBefore(sensor)) {
    return lit;
  }
  const Eigen::Vector3d& from = sensor.position;
  const Eigen::Vector3d& looks = sensor.direction;
  const double squared_reach = reach * reach;
  std::array<double, LedSet{}.size()> ahead;        // distance along the direction, or 0 if out of range
  for (std::size_t k = 0; k < points.count; ++k) {  // without branches, so that compilers vectorise it
    const double x = points.x[k] - from.x();
    const double y = points.y[k] - from.y();
    const double z = points.z[k] - from.z();
    // summed in the same order as Eigen
    const double way_ahead = looks.x() * x + looks.y() * y + looks.z() * z;
    ahead[k] = x * x + y * y + z * z <= squared_reach ? way_ahead : 0.0;
  }
  std::uint64_t found = 0;
  for (std::size_t k = 0; k < points.count; ++k) {
    found |= static_cast<std::uint64_t>(ahead[k] > 0.0) << k;
  }
  return lit & LedSet(found);
}

/// The lights that are before the sensor, within its range, and not hidden by the robot that carries them.
/// @param same result for all sensors of the ring
LedSet LightSearch::facingLights(const Space& space, const IlluminatedSensor& sensor, const Lights& lights,
                                 const LedShades::SameForAll& same) {
  if (lights.areBehind(sensor)) {
    return {};
  }
  LedSet facing = lights.before(sensor);
  if (!lights.cone.isWhole()) {
    visitLeds(facing, [&](std::size_t k) { facing[k] = lights.cone.holds(sensor.position - lights.points[k]); });
  }
  const LedSet unsure = facing & ~same.free;
  if (unsure.none()) {
    return facing;
  }
  return facing & ~shades_.hidden(inBody(space.entities.pose[lights.owner], sensor.position), unsure);
}

/// Whether an entity could be between a ring and the lights of one entity. @param rays sphere around both
bool LightSearch::mayStandBetween(const Space& space, const IlluminatedRing& ring, const Lights& lights,
                                  const RayBundle& rays) {
  if (space.terrain) {
    return true;
  }
  const auto is_other = [&](Row row) { return row != ring.self && row != lights.owner; };
  bool is_large_between = false;
  space.index.visitLarge(rays.centre, rays.radius, [&](const PositionalIndex::LargeOutline& large) {
    is_large_between = is_other(large.row);
    return !is_large_between;
  });
  if (is_large_between) {
    return true;
  }
  near_.clear();
  space.index.collectPlaces(rays.centre, rays.radius + space.index.prismMargin(), near_);
  // seen from above, all rays are within this distance of the line between the centres of ring and lights
  const Eigen::Vector2d from = ring.centre.head<2>();
  const Eigen::Vector2d way = lights.box.center().head<2>() - from;
  const double width = std::max(ring.radius, lights.radiusFromAbove()) + kRounding;
  const bool has_prisms = std::any_of(space.engines.begin(), space.engines.end(),
                                      [](const Engine* engine) { return engine->hitsPrisms(); });
  const double outline_reach = has_prisms ? M_SQRT2 : 1.0;  // factor by which prisms exceed outlines
  const double squared_length = std::max(way.squaredNorm(), kRounding * kRounding);
  return std::any_of(near_.begin(), near_.end(), [&](PositionalIndex::Place place) {
    const PositionalIndex::Outline& outline = space.index.at(place);
    const Eigen::Vector2d to_outline = outline.position - from;
    const double fraction = std::clamp(to_outline.dot(way) / squared_length, 0.0, 1.0);
    const double reach = width + outline_reach * outline.radius;
    return is_other(outline.row) && (to_outline - fraction * way).squaredNorm() <= reach * reach;
  });
}

/// Removes the lights that another entity hides. All rays of a source are cast together.
/// @param rays without segments
void LightSearch::leaveOutOccluded(const Space& space, const IlluminatedRing& ring, const Lights& lights,
                                   RayBundle rays) {
  segments_.clear();
  for (std::size_t i = 0; i < ring.sensors.size(); ++i) {
    visitLeds(seen_[i], [&](std::size_t k) { segments_.push_back({ring.sensors[i].position, lights.points[k]}); });
  }
  if (segments_.empty()) {
    return;
  }
  hits_.resize(segments_.size());
  rays.segments = Span<const Segment>(segments_.data(), segments_.size());
  space.raycast(rays, Span<RayHit>(hits_.data(), hits_.size()));
  std::size_t next = 0;
  for (std::size_t i = 0; i < ring.sensors.size(); ++i) {
    const LedSet asked = seen_[i];
    visitLeds(asked, [&](std::size_t k) { seen_[i][k] = hits_[next++].fraction >= 1.0 - kOwnSurface; });
  }
}

std::size_t LightSearch::findFacing(const Space& space, const IlluminatedRing& ring, Lights& lights) {
  shades_.begin(*space.entities.model[lights.owner], space.joints[lights.owner]);
  const LedShades::SameForAll same = shades_.sameForAll(eyesOf(ring, space.entities.pose[lights.owner]));
  lights.lit &= ~same.hidden;
  seen_.resize(ring.sensors.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < ring.sensors.size(); ++i) {
    seen_[i] = facingLights(space, ring.sensors[i], lights, same);
    visitLeds(seen_[i], [&](std::size_t) { ++count; });
  }
  return count;
}

/// Adds the light of one entity on the ring.
void LightSearch::addLights(const Space& space, const IlluminatedRing& ring, Row row) {
  Lights lights(space, row, ring);
  if (lights.lit.none()) {
    return;
  }
  const std::size_t count = findFacing(space, ring, lights);
  if (count == 0) {
    return;
  }
  const RayBundle rays = lights.bundleFrom(ring);
  if (mayStandBetween(space, ring, lights, rays)) {  // a cheap check that avoids most rays
    leaveOutOccluded(space, ring, lights, rays);
  }
  found_.reserve(count);
  for (std::size_t i = 0; i < ring.sensors.size(); ++i) {
    visitLeds(seen_[i], [&](std::size_t k) {
      const Eigen::Vector3d offset = lights.points[k] - ring.sensors[i].position;
      found_.add({i, lights.brightness[k], offset}, ring.sensors[i].direction.dot(offset));
    });
  }
}

const LightOnRing& LightSearch::find(const Space& space, const IlluminatedRing& ring, const std::vector<Row>& lit) {
  found_.clear();
  for (const Row row : lit) {
    addLights(space, ring, row);
  }
  return found_;
}

void LightOnRing::reserve(std::size_t more) {
  const std::size_t room = count_ + more;
  if (room > sensor_.size()) {
    sensor_.resize(room);
    for (std::vector<double>* column : {&brightness_, &x_, &y_, &z_, &ahead_, &shares_}) {
      column->resize(room);
    }
  }
}

void LightOnRing::addTo(double* sums) const {
  for (std::size_t i = 0; i < count_; ++i) {
    // summed in the same order as Eigen
    const double squared_distance = x_[i] * x_[i] + y_[i] * y_[i] + z_[i] * z_[i];
    shares_[i] = Light::share(brightness_[i], ahead_[i], squared_distance);
  }
  for (std::size_t i = 0; i < count_; ++i) {
    sums[sensor_[i]] += shares_[i];
  }
}

}  // namespace swarmanoid::devices
