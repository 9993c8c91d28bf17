/// What all rings of light sensors have in common: each adds up the light of the LEDs and lamps before it, by the law
/// of Light::share, and saturates where an implementation states no other response. They sit where the links light_0,
/// light_1, ... are, or, if the robot has none of them, proximity_0, proximity_1, ...
///
/// A ring of a robot of its own is its struct with `std::array<float, kCount> value`, and a class such as
///
///     class MyLightSensor final : public LightRingSensor<MyLightSensor, MyLight, MyLight::kCount> {
///      public:
///       static PluginDescription describe() { return describeRing("12 light sensors around the body."); }
///       static float& valueOf(Instance& instance, std::size_t sensor) { return instance.readings->value[sensor]; }
///     };
#pragma once

#include <array>
#include <memory>
#include <string>

#include "field_numbers.hpp"
#include "light_sources.hpp"
#include "parameters.hpp"
#include "ring_geometry.hpp"
#include "swarmanoid_interface/devices/light.hpp"
#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid::devices {

static_assert(Light::kMostSensors == kMostRingSensors);

template <class Device, int count>
struct LightInstance : BasicSensorInstance<Device> {
  std::shared_ptr<const RingGeometry<count>> ring;
};

/// `Ring` derives from this, and has `static float& valueOf(Instance&, std::size_t)`, where the reading of a sensor is.
/// Another law than Light::response is a `static float response(double sum)` of its own, as the one here.
template <class Ring, class Device, int count, class InstanceOfRing = LightInstance<Device, count>>
class LightRingSensor : public SensorOf<Device, InstanceOfRing> {
 public:
  using Instance = InstanceOfRing;

  /// @param sum of the shares of light that a sensor gets @return what it reads
  static float response(double sum) { return Light::response(sum); }

  void configure(const Configuration& parameters) override { range_ = parameters.number("range", Light::kUsualRange); }

  void sense(const Space& space, std::size_t first, std::size_t last) override {
    for (std::size_t k = first; k < last; ++k) {
      senseOne(space, this->instances_[k]);
    }
  }

 protected:
  /// @param implementation its name; the inverse square law is used where an experiment names none
  static PluginDescription describeRing(const std::string& summary,
                                        const std::string& implementation = "inverse_square") {
    PluginDescription description;
    description.label = Device::kType;
    description.implementation = implementation;
    description.is_default = implementation == "inverse_square";
    description.summary = summary;
    description.parameters = {number("range", "m", numberText(Light::kUsualRange), {0.001, 100.0},
                                     "Distance beyond which a source gives no light.")};
    return description;
  }

  void prepareInstance(const Space& space, Instance& instance) override {
    instance.ring = rings_.of(space.entities.model[instance.row], Device::kType, {"light", "proximity"});
  }

  /// For each sensor that feels light a ray to where it looks, by its `value` up to 10 cm long.
  void drawOne(const Space& space, const InstanceOfRing& instance, DeviceDrawing& drawing) const override {
    constexpr double kLongest = 0.1;  // m
    const RingGeometry<count>& ring = *instance.ring;
    const Pose& pose = space.entities.pose[instance.row];
    const auto& values = numbersOf(this->delivered(instance), "value", ring.size());
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (values[i] > 0.0) {
        const auto column = static_cast<Eigen::Index>(i);
        const Eigen::Vector3d from = ring.from.col(column);
        drawing.line(pose.toWorld(from), pose.toWorld(from + kLongest * values[i] * ring.direction.col(column)),
                     colors::kOrange);
      }
    }
  }

 private:
  void senseOne(const Space& space, Instance& instance) const {
    const RingGeometry<count>& ring = *instance.ring;
    const Pose& pose = space.entities.pose[instance.row];
    const Eigen::Vector3d centre = pose.toWorld(ring.centre);
    if (isDark(space, instance.row, centre, ring.radius + range_)) {
      const float dark = Ring::response(0.0);
      for (std::size_t i = 0; i < ring.size(); ++i) {
        Ring::valueOf(instance, i) = dark;
      }
      return;
    }
    std::array<IlluminatedSensor, RingGeometry<count>::kMost> sensors;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const auto column = static_cast<Eigen::Index>(i);
      sensors[i].position = pose.toWorld(ring.from.col(column));
      sensors[i].direction = pose.orientation * ring.direction.col(column);
    }
    illuminate(space, {instance.row, centre, ring.radius, range_, {sensors.data(), ring.size()}});
    for (std::size_t i = 0; i < ring.size(); ++i) {
      Ring::valueOf(instance, i) = Ring::response(sensors[i].sum);
    }
  }

  double range_ = Light::kUsualRange;
  Rings<count> rings_;
};

}  // namespace swarmanoid::devices
