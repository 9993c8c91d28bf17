/// Base class of infrared distance sensors with fixed directions: each reads the distance straight ahead to the first
/// solid, terrain or floor, by Distance::reading. The sensors are at the links distance_0, distance_1, ..., and look
/// along the x axes of the links.
///
/// To add distance sensors, write their struct with `range_min` and `range_max`, and a class such as
///
///     class MyDistanceSensor final : public DistanceRingSensor<MyDistanceSensor, MyDistance, MyDistance::kCount> {
///      public:
///       static PluginDescription describe() { return describeRing("8 distance sensors.", {0.04, 0.3}); }
///       static float& valueOf(Instance& instance, std::size_t sensor) { return instance.readings->value[sensor]; }
///     };
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "common/parameters.hpp"
#include "common/surface_angles.hpp"
#include "ring_geometry.hpp"
#include "sampled_ring.hpp"
#include "surroundings/distance_rays.hpp"
#include "swarmanoid_interface/devices/distance.hpp"
#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid::devices {

static_assert(Distance::kMostSensors == kMostRingSensors);

template <class Device, int count>
struct DistanceInstance : BasicSensorInstance<Device> {
  std::shared_ptr<const RingGeometry<count>> ring;
  bool is_clear = false;  // whether all readings are infinite

  void archive(StateArchive& state) { state(is_clear); }
};

/// `Ring` derives from this, and has `static float& valueOf(Instance&, std::size_t)`, the reading of a sensor.
template <class Ring, class Device, int count, class InstanceOfRing = DistanceInstance<Device, count>>
class DistanceRingSensor : public SensorOf<Device, InstanceOfRing> {
 public:
  using Instance = InstanceOfRing;

  void configure(const Configuration& parameters) override {
    range_ = {parameters.number("range_min"), parameters.number("range_max")};
    refuseEmptyRange(range_, parameters);
    reach_ = range_.maximum;
    folds_ = parameters.text("too_close", kReported) == kFolded;
  }

  void sense(const Space& space, std::size_t first, std::size_t last) override {
    for (std::size_t k = first; k < last; ++k) {
      senseOne(space, this->instances_[k]);
    }
  }

  // For the implementation `sampled`.
  static constexpr SampledLaw kSampledLaw{Stimulus::kObstacle, {0.0, Distance::kFarthest}, kInfinity};
  double range() const { return range_.maximum; }

 protected:
  /// The table determines the length of the rays, and its finite readings the measuring range.
  static std::vector<Parameter> parametersBesideTable() { return {}; }
  void setRange(const SampleTable& table, const Configuration& /*parameters*/) {
    range_ = table.finiteReadings();
    reach_ = table.farthest() + kSampledMargin;
  }

  template <class Visit>
  void visitFelt(const Space& space, const Instance& instance, Visit visit) const {
    Rays rays = raysOf(space, instance);
    if (!mayMeasure(space, rays.bundle, rays.lowest())) {
      return;
    }
    Segments segments;
    Hits hits;
    castRays(space, rays, segments, hits);
    visitSurfaces<RingGeometry<count>::kMost>(
        space, rays.bundle, Span<const RayHit>(hits.data(), rays.bundle.segments.size()), castDistances,
        [&](std::size_t sensor, double way, double angle) { visit(sensor, way, angle, 1.0); });
  }

  /// @param usual default measuring range [m]
  static PluginDescription describeRing(const std::string& summary, Range usual) {
    PluginDescription description;
    description.label = Device::kType;
    description.implementation = "rays";
    description.is_default = true;
    description.summary = summary;
    const Range any{0.0, Distance::kFarthest};
    description.parameters = {
        number("range_min", "m", numberText(usual.minimum), any, "Minimum range; nearer objects are too close."),
        number("range_max", "m", numberText(usual.maximum), any, "Maximum range."), tooCloseParameter()};
    return description;
  }

  void prepareInstance(const Space& space, Instance& instance) override {
    instance.ring = rings_.of(space.entities.model[instance.row], Device::kType, {"distance"});
    instance.readings->range_min = static_cast<float>(range_.minimum);
    instance.readings->range_max = static_cast<float>(range_.maximum);
  }

 private:
  using Segments = std::array<Segment, RingGeometry<count>::kMost>;
  using Hits = std::array<RayHit, RingGeometry<count>::kMost>;

  struct Rays {
    typename RingGeometry<count>::Points from;
    typename RingGeometry<count>::Points to;
    RayBundle bundle;

    double lowest() const { return std::min(from.row(2).minCoeff(), to.row(2).minCoeff()); }
  };

  /// The rays of a robot; the bundle has no segments yet.
  Rays raysOf(const Space& space, const Instance& instance) const {
    const RingGeometry<count>& ring = *instance.ring;
    const Pose& pose = space.entities.pose[instance.row];
    const Eigen::Matrix3d rotation = pose.orientation.toRotationMatrix();
    Rays rays;
    rays.from = (rotation * ring.from).colwise() + pose.position;
    rays.to = rays.from + (reach_ * rotation) * ring.direction;
    rays.bundle.centre = pose.toWorld(ring.centre);
    rays.bundle.radius = ring.radius + reach_;
    rays.bundle.ignored = instance.row;
    return rays;
  }

  /// @param rays their segments are set
  static void castRays(const Space& space, Rays& rays, Segments& segments, Hits& hits) {
    const auto size = static_cast<std::size_t>(rays.from.cols());
    for (std::size_t i = 0; i < size; ++i) {
      segments[i] = {rays.from.col(static_cast<Eigen::Index>(i)), rays.to.col(static_cast<Eigen::Index>(i))};
    }
    rays.bundle.segments = Span<const Segment>(segments.data(), size);
    castDistances(space, rays.bundle, Span<RayHit>(hits.data(), size));
  }

  void senseOne(const Space& space, Instance& instance) const {
    const std::size_t size = instance.ring->size();
    Rays rays = raysOf(space, instance);
    if (!mayMeasure(space, rays.bundle, rays.lowest())) {
      for (std::size_t i = 0; !instance.is_clear && i < size; ++i) {
        Ring::valueOf(instance, i) = Distance::reading(kInfinity, range_);
      }
      instance.is_clear = true;
      return;
    }
    instance.is_clear = false;
    Segments segments;
    Hits hits;
    castRays(space, rays, segments, hits);
    for (std::size_t i = 0; i < size; ++i) {
      const double distance = hits[i].isHit() ? hits[i].fraction * reach_ : kInfinity;
      Ring::valueOf(instance, i) =
          folds_ ? Distance::foldedReading(distance, range_) : Distance::reading(distance, range_);
    }
  }

  Range range_;         // measuring range, m
  double reach_ = 0.0;  // length of the rays, m
  bool folds_ = false;  // whether targets that are too close read as farther ones
  Rings<count> rings_;
};

}  // namespace swarmanoid::devices
