/// Base class of rings of infrared proximity sensors with one short ray each. The response falls from 1 at contact to 0
/// at the range, as a cubic polynomial of the distance unless an implementation has another law.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "common/field_numbers.hpp"
#include "common/parameters.hpp"
#include "common/surface_angles.hpp"
#include "ray_ring.hpp"
#include "sampled_ring.hpp"
#include "swarmanoid_interface/devices/proximity.hpp"
#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid::devices {

static_assert(Proximity::kMostSensors == kMostRingSensors);

template <class Device, int count>
struct ProximityInstance : BasicSensorInstance<Device> {
  std::shared_ptr<const RayRing<count>> ring;
  bool is_clear = true;  // whether all readings are 0

  void archive(StateArchive& state) { state(is_clear); }
};

/// `Ring` derives from this, and has `static float& valueOf(Instance&, std::size_t)`, the reading of a sensor. A ring
/// with another law than the polynomial defines its own `static float response(double fraction)`, like the one here.
/// Rays are drawn up to their hits, in the shade of the struct's `value`, with a point at each hit.
template <class Ring, class Device, int count, class InstanceOfRing = ProximityInstance<Device, count>>
class ProximityRingSensor : public SensorOf<Device, InstanceOfRing> {
 public:
  using Instance = InstanceOfRing;

  /// @param fraction of the range at which the ray hits something: 0 at contact, 1 at the range or beyond
  /// @return from 0 to 1; must be 0 at the range, since sensors without an obstacle nearby read 0
  static float response(double fraction) { return Proximity::response(fraction); }

  void configure(const Configuration& parameters) override {
    range_ = parameters.number("range", Proximity::kUsualRange);
  }

  void sense(const Space& space, std::size_t first, std::size_t last) override {
    for (std::size_t k = first; k < last; ++k) {
      senseOne(space, this->instances_[k]);
    }
  }

  // For the implementation `sampled`.
  static constexpr SampledLaw kSampledLaw{Stimulus::kObstacle, {0.0, 1.0}, 0.0};
  double range() const { return range_; }

 protected:
  static std::vector<Parameter> parametersBesideTable() { return {}; }
  void setRange(const SampleTable& table, const Configuration& /*parameters*/) {
    range_ = table.farthest() + kSampledMargin;
  }

  template <class Visit>
  void visitFelt(const Space& space, const Instance& instance, Visit visit) const {
    RayBundle rays = bundleOf(space, instance);
    if (!space.mayHit(rays)) {
      return;
    }
    Segments segments;
    Hits hits;
    castRays(space, instance, segments, hits, rays);
    visitSurfaces<RingGeometry<count>::kMost>(
        space, rays, Span<const RayHit>(hits.data(), rays.segments.size()),
        [](const Space& in, const RayBundle& beside, Span<RayHit> found) { in.raycast(beside, found); },
        [&](std::size_t sensor, double way, double angle) { visit(sensor, way, angle, 1.0); });
  }

  /// @param implementation its name; `polynomial` is the default of experiments
  static PluginDescription describeRing(const std::string& summary, const std::string& implementation = "polynomial") {
    PluginDescription description;
    description.label = Device::kType;
    description.implementation = implementation;
    description.is_default = implementation == "polynomial";
    description.summary = summary;
    description.parameters = {number("range", "m", numberText(Proximity::kUsualRange), {0.001, 1.0},
                                     "Distance at which the response has fallen to 0.")};
    return description;
  }

  void prepareInstance(const Space& space, Instance& instance) override {
    instance.ring = rings_.of(space.entities.model[instance.row], Device::kType, {"proximity"}, range_);
  }

  void drawOne(const Space& space, const Instance& instance, DeviceDrawing& drawing) const override {
    const std::size_t size = instance.ring->size();
    const std::vector<double>& values = numbersOf(this->delivered(instance), "value", size);
    Segments segments;
    Hits hits;
    RayBundle rays = bundleOf(space, instance);
    castRays(space, instance, segments, hits, rays);
    for (std::size_t i = 0; i < size; ++i) {
      const auto& [from, to] = segments[i];
      const Eigen::Vector3d end = from + hits[i].fraction * (to - from);
      const Color shade = DeviceDrawing::shade(values[i]);
      drawing.line(from, end, shade);
      if (hits[i].isHit()) {
        drawing.point(end, shade);
      }
    }
  }

 private:
  using Segments = std::array<Segment, RingGeometry<count>::kMost>;
  using Hits = std::array<RayHit, RingGeometry<count>::kMost>;

  RayBundle bundleOf(const Space& space, const Instance& instance) const {
    RayBundle rays = instance.ring->bundle(space.entities.pose[instance.row]);
    rays.ignored = instance.row;
    return rays;
  }

  /// @param rays of bundleOf; all segments of the ring are set
  void castRays(const Space& space, const Instance& instance, Segments& segments, Hits& hits, RayBundle& rays) const {
    const std::size_t size = instance.ring->size();
    instance.ring->aim(space.entities.pose[instance.row], {segments.data(), size});
    rays.segments = Span<const Segment>(segments.data(), size);
    space.raycast(rays, Span<RayHit>(hits.data(), size));
  }

  using Fractions = std::array<double, RingGeometry<count>::kMost>;

  /// Casts only the rays near an obstacle. Against circles, such as most robots, it casts them in the robot's frame.
  /// @param fractions output: where each ray hits something; 1: no hit @return mask of the rays near an obstacle
  RayMask castNear(const Space& space, const Instance& instance, const Obstacles& obstacles,
                   Fractions& fractions) const {
    const RayRing<count>& ring = *instance.ring;
    const UprightPose pose(space.entities.pose[instance.row]);
    RayMask cast = 0;
    fractions.fill(1.0);
    ring.visitNear(
        obstacles, pose,
        [&](const Eigen::Vector2d& centre, double radius, RayMask near) {
          cast |= near;
          visitRays(near,
                    [&](std::size_t i) { fractions[i] = std::min(fractions[i], ring.entryInto(centre, radius, i)); });
        },
        [&](const Obstacles::Solid& solid, RayMask near) {
          cast |= near;
          visitRays(near, [&](std::size_t i) {
            RayHit hit;
            hit.fraction = fractions[i];
            space.castRayAt(solid, ring.ray(pose, i), hit);
            fractions[i] = hit.fraction;
          });
        });
    return cast;
  }

  /// Casts all rays, with results as castNear.
  RayMask castAll(const Space& space, const Instance& instance, RayBundle& rays, Fractions& fractions) const {
    Segments segments;
    Hits hits;
    castRays(space, instance, segments, hits, rays);
    std::transform(hits.begin(), hits.end(), fractions.begin(), [](const RayHit& hit) { return hit.fraction; });
    return instance.ring->all();
  }

  void senseOne(const Space& space, Instance& instance) const {
    const RayRing<count>& ring = *instance.ring;
    RayBundle rays = bundleOf(space, instance);
    const Obstacles obstacles = space.findObstacles(rays);
    if (!instance.is_clear) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        Ring::valueOf(instance, i) = 0.0F;
      }
      instance.is_clear = true;
    }
    if (obstacles.isEmpty()) {
      return;
    }
    Fractions fractions;
    const bool is_near = !obstacles.areAnywhere() && space.entities.pose[instance.row].isUpright();
    const RayMask cast =
        is_near ? castNear(space, instance, obstacles, fractions) : castAll(space, instance, rays, fractions);
    visitRays(cast, [&](std::size_t i) { Ring::valueOf(instance, i) = Ring::response(fractions[i]); });
    instance.is_clear = cast == 0;
  }

  double range_ = Proximity::kUsualRange;
  RayRings<count> rings_;
};

}  // namespace swarmanoid::devices
