/// What all infrared distance sensors that look in fixed directions have in common: each says how far it is to the
/// first solid, terrain or floor straight ahead, by the law of Distance::reading. They sit where the links distance_0,
/// distance_1, ... are, and look along the x axes of these.
///
/// Sensors of a robot of its own are its struct with `range_min` and `range_max`, and a class such as
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

#include "distance_rays.hpp"
#include "parameters.hpp"
#include "ring_geometry.hpp"
#include "swarmanoid_interface/devices/distance.hpp"
#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid::devices {

static_assert(Distance::kMostSensors == kMostRingSensors);

template <class Device, int count>
struct DistanceInstance : BasicSensorInstance<Device> {
  std::shared_ptr<const RingGeometry<count>> ring;
  bool is_clear = false;  // whether all readings are infinite
};

/// `Ring` derives from this, and has `static float& valueOf(Instance&, std::size_t)`, where the reading of a sensor is.
template <class Ring, class Device, int count, class InstanceOfRing = DistanceInstance<Device, count>>
class DistanceRingSensor : public SensorOf<Device, InstanceOfRing> {
 public:
  using Instance = InstanceOfRing;

  void configure(const Configuration& parameters) override {
    range_ = {parameters.number("range_min"), parameters.number("range_max")};
    if (range_.minimum >= range_.maximum) {
      throw ConfigError(parameters.location(), "range_min: found " + numberText(range_.minimum) +
                                                   ", allowed: less than range_max, which is " +
                                                   numberText(range_.maximum));
    }
  }

  void sense(const Space& space, std::size_t first, std::size_t last) override {
    for (std::size_t k = first; k < last; ++k) {
      senseOne(space, this->instances_[k]);
    }
  }

 protected:
  /// @param usual what its sensors can measure, where an experiment does not say it [m]
  static PluginDescription describeRing(const std::string& summary, Range usual) {
    PluginDescription description;
    description.label = Device::kType;
    description.implementation = "rays";
    description.is_default = true;
    description.summary = summary;
    const Range any{0.0, Distance::kFarthest};
    description.parameters = {
        number("range_min", "m", numberText(usual.minimum), any, "Distance below which something is too close."),
        number("range_max", "m", numberText(usual.maximum), any, "Distance beyond which nothing is in range.")};
    return description;
  }

  void prepareInstance(const Space& space, Instance& instance) override {
    instance.ring = rings_.of(space.entities.model[instance.row], Device::kType, {"distance"});
    instance.readings->range_min = static_cast<float>(range_.minimum);
    instance.readings->range_max = static_cast<float>(range_.maximum);
  }

 private:
  void senseOne(const Space& space, Instance& instance) const {
    const RingGeometry<count>& ring = *instance.ring;
    const std::size_t size = ring.size();
    const Pose& pose = space.entities.pose[instance.row];
    const Eigen::Matrix3d rotation = pose.orientation.toRotationMatrix();
    const typename RingGeometry<count>::Points from = (rotation * ring.from).colwise() + pose.position;
    const typename RingGeometry<count>::Points to = from + (range_.maximum * rotation) * ring.direction;
    RayBundle rays;
    rays.centre = pose.toWorld(ring.centre);
    rays.radius = ring.radius + range_.maximum;
    rays.ignored = instance.row;
    if (!mayMeasure(space, rays, std::min(from.row(2).minCoeff(), to.row(2).minCoeff()))) {
      for (std::size_t i = 0; !instance.is_clear && i < size; ++i) {
        Ring::valueOf(instance, i) = Distance::reading(kInfinity, range_);
      }
      instance.is_clear = true;
      return;
    }
    instance.is_clear = false;
    std::array<Segment, RingGeometry<count>::kMost> segments;
    std::array<RayHit, RingGeometry<count>::kMost> hits;
    for (std::size_t i = 0; i < size; ++i) {
      segments[i] = {from.col(static_cast<Eigen::Index>(i)), to.col(static_cast<Eigen::Index>(i))};
    }
    rays.segments = Span<const Segment>(segments.data(), size);
    castDistances(space, rays, Span<RayHit>(hits.data(), size));
    for (std::size_t i = 0; i < size; ++i) {
      const double distance = hits[i].isHit() ? hits[i].fraction * range_.maximum : kInfinity;
      Ring::valueOf(instance, i) = Distance::reading(distance, range_);
    }
  }

  Range range_;
  Rings<count> rings_;
};

}  // namespace swarmanoid::devices
