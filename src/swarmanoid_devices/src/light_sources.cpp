#include "light_sources.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <vector>

#include "color_blob_finder.hpp"
#include "light_cone.hpp"
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
  LightCone cone;
};

/// Whether anything of it shines: false for most of what is near.
bool shines(const Space& space, Row row) {
  const EntityModel& model = *space.entities.model[row];
  if (!model.is_robot) {
    return isLuminous(model) && space.ownColor(row).isLit();
  }
  const Span<const Color> leds = space.leds[row];
  return std::any_of(leds.begin(), leds.end(), [](Color color) { return color.isLit(); });
}

Lights lightsOf(const Space& space, Row row) {
  const EntityModel& model = *space.entities.model[row];
  const Pose& pose = space.entities.pose[row];
  const Span<const Color> leds = space.leds[row];
  const double intensity = space.property(row, kIntensity).value_or(1.0);
  Lights lights;
  lights.owner = row;
  lights.cone = lightConeOf(space, row);
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

/// A box that holds all rays from the ring to the lights.
Eigen::AlignedBox3d boxAround(const IlluminatedRing& ring, const Lights& lights) {
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(ring.radius);
  Eigen::AlignedBox3d box(ring.centre - reach, ring.centre + reach);
  for (std::size_t k = 0; k < lights.lit.size(); ++k) {
    if (lights.lit[k]) {
      box.extend(lights.points[k]);
    }
  }
  return box;
}

/// The lights that are before the sensor, within its range, and not hidden by the robot that carries them.
LedSet facingLights(const Space& space, const IlluminatedSensor& sensor, double range, const Lights& lights) {
  LedSet facing;
  for (std::size_t k = 0; k < facing.size(); ++k) {
    if (lights.lit[k]) {
      const Eigen::Vector3d offset = lights.points[k] - sensor.position;
      facing[k] =
          sensor.direction.dot(offset) > 0.0 && offset.squaredNorm() <= range * range && lights.cone.holds(-offset);
    }
  }
  if (facing.none()) {
    return facing;
  }
  const Pose& pose = space.entities.pose[lights.owner];
  const Eigen::Vector3d eye = pose.orientation.conjugate() * (sensor.position - pose.position);
  return facing & ~hiddenLeds(*space.entities.model[lights.owner], space.joints[lights.owner], eye, facing);
}

/// What a thread keeps between calls so that a steady state allocates nothing.
struct Scratch {
  std::vector<Row> near;
  std::vector<LedSet> seen;  // of one source, by sensor
  std::vector<Segment> segments;
  std::vector<RayHit> hits;
};

/// Leaves out the lights that something else stands before. All rays of a source are cast together.
/// @param rays without segments
void leaveOutOccluded(const Space& space, const IlluminatedRing& ring, const Lights& lights, RayBundle rays,
                      Scratch& scratch) {
  scratch.segments.clear();
  for (std::size_t i = 0; i < ring.sensors.size(); ++i) {
    for (std::size_t k = 0; scratch.seen[i].any() && k < lights.lit.size(); ++k) {
      if (scratch.seen[i][k]) {
        scratch.segments.push_back({ring.sensors[i].position, lights.points[k]});
      }
    }
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
    for (std::size_t k = 0; asked.any() && k < asked.size(); ++k) {
      if (asked[k]) {
        scratch.seen[i][k] = scratch.hits[next++].fraction >= 1.0 - kOwnSurface;
      }
    }
  }
}

void addLights(const Space& space, const IlluminatedRing& ring, Row row, Scratch& scratch) {
  const Lights lights = lightsOf(space, row);
  if (lights.lit.none()) {
    return;
  }
  scratch.seen.resize(ring.sensors.size());
  for (std::size_t i = 0; i < ring.sensors.size(); ++i) {
    scratch.seen[i] = facingLights(space, ring.sensors[i], ring.range, lights);
  }
  const RayBundle rays = bundleAround(boxAround(ring, lights), ring.self, row);
  if (space.mayHit(rays)) {  // a cheap question that spares most rays
    leaveOutOccluded(space, ring, lights, rays, scratch);
  }
  for (std::size_t i = 0; i < ring.sensors.size(); ++i) {
    IlluminatedSensor& sensor = ring.sensors[i];
    const LedSet& seen = scratch.seen[i];
    for (std::size_t k = 0; seen.any() && k < seen.size(); ++k) {
      if (seen[k]) {
        sensor.sum += Light::share(lights.brightness[k], sensor.direction, lights.points[k] - sensor.position);
      }
    }
  }
}

/// Fills `near` with what shines there, but for the robot itself, in no order.
void findShining(const Space& space, Row self, const Eigen::Vector3d& centre, double reach, std::vector<Row>& near) {
  near.clear();
  space.index.collect(centre, reach, near);
  const auto is_dark = [&](Row row) { return row == self || !shines(space, row); };
  near.erase(std::remove_if(near.begin(), near.end(), is_dark), near.end());
}

Scratch& scratchOfThread() {
  thread_local Scratch scratch;
  return scratch;
}

}  // namespace

bool isDark(const Space& space, Row self, const Eigen::Vector3d& centre, double reach) {
  std::vector<Row>& near = scratchOfThread().near;
  findShining(space, self, centre, reach, near);
  return near.empty();
}

void illuminate(const Space& space, const IlluminatedRing& ring) {
  Scratch& scratch = scratchOfThread();
  findShining(space, ring.self, ring.centre, ring.radius + ring.range, scratch.near);
  const Entities& entities = space.entities;
  std::sort(scratch.near.begin(), scratch.near.end(),
            [&](Row a, Row b) { return entities.number[a] < entities.number[b]; });
  for (const Row row : scratch.near) {
    addLights(space, ring, row, scratch);
  }
}

}  // namespace swarmanoid::devices
