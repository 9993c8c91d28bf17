#include "light_sources.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "light_cone.hpp"
#include "near_obstacles.hpp"
#include "swarmanoid_interface/devices/light.hpp"
#include "swarmanoid_space/rays/led_shades.hpp"

namespace swarmanoid::devices {
namespace {

/// The lit LEDs of one entity, or the light of one lamp.
struct Lights {
  Row owner = kNoRow;
  LedPoints points;
  std::array<double, LedSet{}.size()> brightness;  // of those that are lit
  LedSet lit;
  Eigen::AlignedBox3d box;  // around those points, in W [m]
  LightCone cone;
  double reach = 0.0;  // m
};

Lights lightsOf(const Space& space, Row row, const LightReach& reach) {
  const EntityModel& model = *space.entities.model[row];
  const Pose& pose = space.entities.pose[row];
  const Span<const Color> leds = space.leds[row];
  const double intensity = space.property(row, kIntensity).value_or(1.0);
  Lights lights;
  lights.owner = row;
  lights.cone = lightConeOf(space, row);
  lights.reach = reachOfLight(model, reach);
  for (std::size_t k = 0; k < std::min(model.led_positions.size(), lights.lit.size()); ++k) {
    const Color color = model.is_robot ? leds[k] : space.entities.color[row];
    if (color.isLit() && intensity > 0.0) {
      lights.lit[k] = true;
      lights.points[k] = pose.toWorld(model.led_positions[k]);
      lights.brightness[k] = intensity * Light::brightness(color);
      lights.box.extend(lights.points[k]);
    }
  }
  return lights;
}

/// A bundle without segments whose sphere holds all rays from the ring to the lights.
RayBundle bundleBetween(const IlluminatedRing& ring, const Lights& lights) {
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(ring.radius);
  const Eigen::AlignedBox3d box = lights.box.merged({ring.centre - reach, ring.centre + reach});
  RayBundle rays;
  rays.centre = box.center();
  rays.radius = 0.5 * box.diagonal().norm();
  rays.ignored = ring.self;
  rays.also_ignored = lights.owner;
  return rays;
}

/// Whether all lights are behind a sensor: so half of a ring's sensors are.
bool isTurnedAway(const IlluminatedSensor& sensor, const Lights& lights) {
  constexpr double kRounding = 1e-9;  // m
  const Eigen::Vector3d half = 0.5 * lights.box.sizes();
  return sensor.direction.dot(lights.box.center() - sensor.position) + sensor.direction.cwiseAbs().dot(half) <
         -kRounding;
}

/// The lights that are before the sensor, within its range, and not hidden by the robot that carries them.
LedSet facingLights(const Space& space, const IlluminatedSensor& sensor, const Lights& lights, LedShades& shades) {
  LedSet facing;
  if (isTurnedAway(sensor, lights)) {
    return facing;
  }
  visitLeds(lights.lit, [&](std::size_t k) {
    const Eigen::Vector3d offset = lights.points[k] - sensor.position;
    facing[k] = sensor.direction.dot(offset) > 0.0 && offset.squaredNorm() <= lights.reach * lights.reach &&
                lights.cone.holds(-offset);
  });
  if (facing.none()) {
    return facing;
  }
  const Pose& pose = space.entities.pose[lights.owner];
  const Eigen::Vector3d eye = pose.orientation.conjugate() * (sensor.position - pose.position);
  return facing & ~shades.hidden(eye, facing);
}

/// What a thread keeps between calls so that a steady state allocates nothing.
struct Scratch {
  LedShades shades;
  std::vector<PositionalIndex::Place> near;
  std::vector<LedSet> seen;  // of one source, by sensor
  std::vector<Segment> segments;
  std::vector<RayHit> hits;
  std::vector<LightOnSensor> found;
};

/// Whether something could stand between a ring and the lights of one entity. @param rays of a sphere around both
/// @param near scratch
bool mayStandBetween(const Space& space, const IlluminatedRing& ring, const Lights& lights, const RayBundle& rays,
                     std::vector<PositionalIndex::Place>& near) {
  constexpr double kRounding = 1e-9;  // m
  if (space.terrain) {
    return true;
  }
  const auto is_other = [&](Row row) { return row != ring.self && row != lights.owner; };
  for (const PositionalIndex::LargeOutline& large : space.index.large()) {
    if (is_other(large.row) && large.meets(rays.centre, rays.radius)) {
      return true;
    }
  }
  near.clear();
  space.index.collectPlaces(rays.centre, rays.radius + space.index.prismMargin(), near);
  // seen from above all rays are within this distance of the line between the middles of ring and lights
  const Eigen::Vector2d from = ring.centre.head<2>();
  const Eigen::Vector2d way = lights.box.center().head<2>() - from;
  const double width = std::max(ring.radius, 0.5 * lights.box.sizes().head<2>().norm()) + kRounding;
  const double squared_length = std::max(way.squaredNorm(), kRounding * kRounding);
  return std::any_of(near.begin(), near.end(), [&](PositionalIndex::Place place) {
    const PositionalIndex::Outline& outline = space.index.at(place);
    const Eigen::Vector2d to_outline = outline.position - from;
    const double fraction = std::clamp(to_outline.dot(way) / squared_length, 0.0, 1.0);
    const double reach = width + M_SQRT2 * outline.radius;  // prisms reach so far out of it
    return is_other(outline.row) && (to_outline - fraction * way).squaredNorm() <= reach * reach;
  });
}

/// Leaves out the lights that something else stands before. All rays of a source are cast together.
/// @param rays without segments
void leaveOutOccluded(const Space& space, const IlluminatedRing& ring, const Lights& lights, RayBundle rays,
                      Scratch& scratch) {
  scratch.segments.clear();
  for (std::size_t i = 0; i < ring.sensors.size(); ++i) {
    visitLeds(scratch.seen[i], [&](std::size_t k) {
      scratch.segments.push_back({ring.sensors[i].position, lights.points[k]});
    });
  }
  if (scratch.segments.empty()) {
    return;
  }
  scratch.hits.resize(scratch.segments.size());
  rays.segments = Span<const Segment>(scratch.segments.data(), scratch.segments.size());
  space.raycast(rays, Span<RayHit>(scratch.hits.data(), scratch.hits.size()));
  std::size_t next = 0;
  for (std::size_t i = 0; i < ring.sensors.size(); ++i) {
    const LedSet asked = scratch.seen[i];
    visitLeds(asked, [&](std::size_t k) { scratch.seen[i][k] = scratch.hits[next++].fraction >= 1.0 - kOwnSurface; });
  }
}

/// Adds what one entity sheds on the ring.
void addLights(const Space& space, const IlluminatedRing& ring, Row row, Scratch& scratch) {
  const Lights lights = lightsOf(space, row, ring.reach);
  if (lights.lit.none()) {
    return;
  }
  scratch.seen.resize(ring.sensors.size());
  scratch.shades.begin(*space.entities.model[row], space.joints[row]);
  bool any = false;
  for (std::size_t i = 0; i < ring.sensors.size(); ++i) {
    scratch.seen[i] = facingLights(space, ring.sensors[i], lights, scratch.shades);
    any = any || scratch.seen[i].any();
  }
  if (!any) {
    return;
  }
  const RayBundle rays = bundleBetween(ring, lights);
  if (mayStandBetween(space, ring, lights, rays, scratch.near)) {  // a cheap question that spares most rays
    leaveOutOccluded(space, ring, lights, rays, scratch);
  }
  for (std::size_t i = 0; i < ring.sensors.size(); ++i) {
    visitLeds(scratch.seen[i], [&](std::size_t k) {
      scratch.found.push_back({i, lights.brightness[k], lights.points[k] - ring.sensors[i].position});
    });
  }
}

}  // namespace

const std::vector<LightOnSensor>& lightOn(const Space& space, const IlluminatedRing& ring,
                                          const std::vector<Row>& lit) {
  thread_local Scratch scratch;
  scratch.found.clear();
  for (const Row row : lit) {
    addLights(space, ring, row, scratch);
  }
  return scratch.found;
}

}  // namespace swarmanoid::devices
