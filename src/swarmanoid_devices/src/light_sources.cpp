#include "light_sources.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <vector>

#include "color_blob_finder.hpp"
#include "swarmanoid_interface/devices/light.hpp"
#include "swarmanoid_space/rays/solid_ray.hpp"

namespace swarmanoid::devices {
namespace {

/// Whether the points at which cameras see its colour shine: LEDs and lamps do, the surface of a prey does not.
bool isLuminous(const EntityModel& model) { return model.is_robot || model.findProperty(kIntensity) >= 0; }

/// The lit LEDs of one entity, or the light of one lamp.
struct Lights {
  Row owner = kNoRow;
  std::array<Eigen::Vector3d, LedSet{}.size()> points;  // in W, of those that are lit, m
  std::array<double, LedSet{}.size()> brightness;       // likewise
  LedSet lit;
};

Lights lightsOf(const Space& space, Row row) {
  const EntityModel& model = *space.entities.model[row];
  const Pose& pose = space.entities.pose[row];
  const Span<const Color> leds = space.leds[row];
  const double intensity = space.property(row, kIntensity).value_or(1.0);
  Lights lights;
  lights.owner = row;
  for (std::size_t k = 0; k < std::min(model.led_positions.size(), lights.lit.size()); ++k) {
    const Color color = model.is_robot ? leds[k] : space.entities.color[row];
    if (color.isLit() && intensity > 0.0) {
      lights.lit[k] = true;
      lights.points[k] = pose.toWorld(model.led_positions[k]);
      lights.brightness[k] = intensity * Light::brightness(color);
    }
  }
  return lights;
}

/// A bundle without segments whose sphere holds all points of a box.
RayBundle bundleAround(const Eigen::AlignedBox3d& box, Row self, Row owner) {
  RayBundle rays;
  rays.centre = box.center();
  rays.radius = 0.5 * box.diagonal().norm();
  rays.ignored = self;
  rays.also_ignored = owner;
  return rays;
}

/// Whether nothing at all is where rays from the ring to the lights run. A cheap question that spares most rays.
bool isClear(const Space& space, const IlluminatedRing& ring, const Lights& lights) {
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(ring.radius);
  Eigen::AlignedBox3d box(ring.centre - reach, ring.centre + reach);
  for (std::size_t k = 0; k < lights.lit.size(); ++k) {
    if (lights.lit[k]) {
      box.extend(lights.points[k]);
    }
  }
  return !space.mayHit(bundleAround(box, ring.self, lights.owner));
}

/// The lights that are before the sensor, within its range, and not hidden by the robot that carries them.
LedSet facingLights(const Space& space, const IlluminatedSensor& sensor, double range, const Lights& lights) {
  LedSet facing;
  for (std::size_t k = 0; k < facing.size(); ++k) {
    if (lights.lit[k]) {
      const Eigen::Vector3d offset = lights.points[k] - sensor.position;
      facing[k] = sensor.direction.dot(offset) > 0.0 && offset.squaredNorm() <= range * range;
    }
  }
  if (facing.none()) {
    return facing;
  }
  const Pose& pose = space.entities.pose[lights.owner];
  const Eigen::Vector3d eye = pose.orientation.conjugate() * (sensor.position - pose.position);
  return facing & ~hiddenLeds(*space.entities.model[lights.owner], space.joints[lights.owner], eye, facing);
}

/// Leaves out the lights that something else stands before.
LedSet withoutOccluded(const Space& space, const IlluminatedSensor& sensor, Row self, const Lights& lights,
                       const LedSet& asked) {
  std::array<Segment, LedSet{}.size()> segments;
  std::array<RayHit, LedSet{}.size()> hits;
  std::size_t count = 0;
  Eigen::AlignedBox3d box(sensor.position);
  for (std::size_t k = 0; k < asked.size(); ++k) {
    if (asked[k]) {
      segments[count++] = {sensor.position, lights.points[k]};
      box.extend(lights.points[k]);
    }
  }
  RayBundle rays = bundleAround(box, self, lights.owner);
  rays.segments = Span<const Segment>(segments.data(), count);
  space.raycast(rays, Span<RayHit>(hits.data(), count));
  LedSet seen = asked;
  std::size_t next = 0;
  for (std::size_t k = 0; k < asked.size(); ++k) {
    if (asked[k]) {
      seen[k] = hits[next++].fraction >= 1.0 - kOwnSurface;
    }
  }
  return seen;
}

void addLights(const Space& space, const IlluminatedRing& ring, Row row) {
  if (!isLuminous(*space.entities.model[row])) {
    return;
  }
  const Lights lights = lightsOf(space, row);
  if (lights.lit.none()) {
    return;
  }
  const bool is_clear = isClear(space, ring, lights);
  for (IlluminatedSensor& sensor : ring.sensors) {
    LedSet seen = facingLights(space, sensor, ring.range, lights);
    if (!is_clear && seen.any()) {
      seen = withoutOccluded(space, sensor, ring.self, lights, seen);
    }
    for (std::size_t k = 0; seen.any() && k < seen.size(); ++k) {
      if (seen[k]) {
        sensor.sum += Light::share(lights.brightness[k], sensor.direction, lights.points[k] - sensor.position);
      }
    }
  }
}

}  // namespace

void illuminate(const Space& space, const IlluminatedRing& ring) {
  // kept between calls so that a steady state allocates nothing
  thread_local std::vector<Row> near;
  near.clear();
  space.index.collect(ring.centre, ring.radius + ring.range, near);
  const Entities& entities = space.entities;
  std::sort(near.begin(), near.end(), [&](Row a, Row b) { return entities.number[a] < entities.number[b]; });
  for (const Row row : near) {
    if (row != ring.self) {
      addLights(space, ring, row);
    }
  }
}

}  // namespace swarmanoid::devices
