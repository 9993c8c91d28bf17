/// What all rings of infrared proximity sensors have in common: one short ray a sensor; the response falls from 1 at
/// contact to 0 at the range, as a cubic polynomial of the distance where an implementation states no other law.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "field_numbers.hpp"
#include "parameters.hpp"
#include "ring_geometry.hpp"
#include "sampled_ring.hpp"
#include "surface_angles.hpp"
#include "swarmanoid_interface/devices/proximity.hpp"
#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid::devices {

static_assert(Proximity::kMostSensors == kMostRingSensors);

template <class Device, int count>
struct ProximityInstance : BasicSensorInstance<Device> {
  std::shared_ptr<const RingGeometry<count>> ring;
  bool is_clear = true;  // whether all readings are 0
};

/// `Ring` derives from this, and has `static float& valueOf(Instance&, std::size_t)`, where the reading of a sensor is.
/// Another law than the polynomial is a `static float response(double fraction)` of its own, as the one here. Drawn are
/// the rays as far as they reach, in the shade of the struct's `value`, with a point where they hit something.
template <class Ring, class Device, int count, class InstanceOfRing = ProximityInstance<Device, count>>
class ProximityRingSensor : public SensorOf<Device, InstanceOfRing> {
 public:
  using Instance = InstanceOfRing;

  /// @param fraction of the range at which something is: 0 at contact, 1 at the range or beyond
  /// @return from 0 to 1; 0 at the range, which is read too where nothing is near
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
  void setRange(const SampleTable& table) { range_ = table.farthest() + kSampledMargin; }

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

  /// @param implementation its name; the polynomial is used where an experiment names none
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
    instance.ring = rings_.of(space.entities.model[instance.row], Device::kType, {"proximity"});
  }

  void drawOne(const Space& space, const Instance& instance, DeviceDrawing& drawing) const override {
    const std::size_t size = instance.ring->size();
    const std::vector<double>& values = numbersOf(this->delivered(instance), "value", size);
    Segments segments;
    Hits hits;
    RayBundle rays = bundleOf(space, instance);
    aim(space, instance, segments);
    if (space.mayHit(rays)) {
      rays.segments = Span<const Segment>(segments.data(), size);
      space.raycast(rays, Span<RayHit>(hits.data(), size));
    }
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

  /// All but the segments.
  RayBundle bundleOf(const Space& space, const Instance& instance) const {
    const RingGeometry<count>& ring = *instance.ring;
    RayBundle rays;
    rays.centre = space.entities.pose[instance.row].toWorld(ring.centre);
    rays.radius = ring.radius + range_;
    rays.ignored = instance.row;
    return rays;
  }

  void aim(const Space& space, const Instance& instance, Segments& segments) const {
    const RingGeometry<count>& ring = *instance.ring;
    const Pose& pose = space.entities.pose[instance.row];
    const Eigen::Matrix3d rotation = pose.orientation.toRotationMatrix();
    const typename RingGeometry<count>::Points from = (rotation * ring.from).colwise() + pose.position;
    const typename RingGeometry<count>::Points to = from + (range_ * rotation) * ring.direction;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      segments[i] = {from.col(static_cast<Eigen::Index>(i)), to.col(static_cast<Eigen::Index>(i))};
    }
  }

  /// @param rays of bundleOf, which get their segments
  void castRays(const Space& space, const Instance& instance, Segments& segments, Hits& hits, RayBundle& rays) const {
    const std::size_t size = instance.ring->size();
    aim(space, instance, segments);
    rays.segments = Span<const Segment>(segments.data(), size);
    space.raycast(rays, Span<RayHit>(hits.data(), size));
  }

  void senseOne(const Space& space, Instance& instance) const {
    const std::size_t size = instance.ring->size();
    RayBundle rays = bundleOf(space, instance);
    if (!space.mayHit(rays)) {
      for (std::size_t i = 0; !instance.is_clear && i < size; ++i) {
        Ring::valueOf(instance, i) = 0.0F;
      }
      instance.is_clear = true;
      return;
    }
    instance.is_clear = false;
    Segments segments;
    Hits hits;
    castRays(space, instance, segments, hits, rays);
    for (std::size_t i = 0; i < size; ++i) {
      Ring::valueOf(instance, i) = Ring::response(hits[i].fraction);
    }
  }

  double range_ = Proximity::kUsualRange;
  Rings<count> rings_;
};

}  // namespace swarmanoid::devices
