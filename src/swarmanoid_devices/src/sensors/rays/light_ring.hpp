/// Base class of rings of light sensors: each sensor adds up the light of the LEDs and lamps before it, by
/// Light::share, and saturates unless an implementation has another response. The sensors are at the links light_0,
/// light_1, ..., or, if the robot has none of them, proximity_0, proximity_1, ...
///
/// To add a ring, write its struct with `std::array<float, kCount> value`, and a class such as
///
///     class MyLightSensor final : public LightRingSensor<MyLightSensor, MyLight, MyLight::kCount> {
///      public:
///       static PluginDescription describe() { return describeRing("12 light sensors around the body."); }
///       static float& valueOf(Instance& instance, std::size_t sensor) { return instance.readings->value[sensor]; }
///     };
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "common/field_numbers.hpp"
#include "common/parameters.hpp"
#include "ring_geometry.hpp"
#include "sampled_ring.hpp"
#include "surroundings/light_sources.hpp"
#include "swarmanoid_interface/devices/light.hpp"
#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid::devices {

static_assert(Light::kMostSensors == kMostRingSensors);

template <class Device, int count>
struct LightInstance : BasicSensorInstance<Device> {
  std::shared_ptr<const RingGeometry<count>> ring;

  void archive(StateArchive& /*state*/) {}
};

/// `Ring` derives from this, and has `static float& valueOf(Instance&, std::size_t)`, the reading of a sensor. A ring
/// with another law than Light::response defines its own `static float response(double sum)`, like the one here.
template <class Ring, class Device, int count, class InstanceOfRing = LightInstance<Device, count>>
class LightRingSensor : public SensorOf<Device, InstanceOfRing> {
 public:
  using Instance = InstanceOfRing;

  /// @param sum of the light shares on a sensor @return reading of the sensor
  static float response(double sum) { return Light::response(sum); }

  void configure(const Configuration& parameters) override {
    const double range = parameters.number("range", Light::kUsualRange);
    reach_ = {range, std::min(range, parameters.number("led_range", 0.0))};
    response_ = {parameters.number("red_weight", 1.0), parameters.number("green_weight", 1.0),
                 parameters.number("blue_weight", 1.0)};
  }

  void prepare(const Space& space) override {
    if (!this->instances_.empty()) {
      lit_.fill(space, reach_);
    }
  }

  void sense(const Space& space, std::size_t first, std::size_t last) override {
    thread_local LightSearch search;  // kept between calls so that a steady state allocates nothing
    for (std::size_t k = first; k < last; ++k) {
      senseOne(space, this->instances_[k], search);
    }
  }

  // For the implementation `sampled`.
  static constexpr SampledLaw kSampledLaw{Stimulus::kLight, {0.0, 1.0}, 0.0};
  double range() const { return reach_.of_lamps; }

 protected:
  void setRange(const SampleTable& table, const Configuration& parameters) {
    const double range = table.farthest() + kSampledMargin;
    reach_ = {range, std::min(range, parameters.number("led_range", 0.0))};
  }

  static std::vector<Parameter> parametersBesideTable() { return {ledRange()}; }

  template <class Visit>
  void visitFelt(const Space& space, const Instance& instance, Visit visit) const {
    const std::vector<Row>& near = shiningOn(space, instance);
    if (near.empty()) {
      return;
    }
    Sensors sensors;
    const IlluminatedRing ring = placedRing(space, instance, sensors);
    thread_local LightSearch search;
    const LightOnRing& lights = search.find(space, ring, near);
    for (std::size_t k = 0; k < lights.size(); ++k) {
      const LightOnSensor light = lights[k];
      const Eigen::Vector3d& direction = sensors[light.sensor].direction;
      const double angle = std::atan2(direction.cross(light.offset).norm(), direction.dot(light.offset));
      visit(light.sensor, light.offset.norm(), angle, light.brightness);
    }
  }

  /// @param implementation its name; `inverse_square` is the default of experiments
  static PluginDescription describeRing(const std::string& summary,
                                        const std::string& implementation = "inverse_square") {
    PluginDescription description;
    description.label = Device::kType;
    description.implementation = implementation;
    description.is_default = implementation == "inverse_square";
    description.summary = summary;
    description.parameters = {number("range", "m", numberText(Light::kUsualRange), {0.001, kFarthest},
                                     "Distance beyond which a source gives no light."),
                              ledRange(),
                              number("red_weight", "", "1", kWeights, "How strongly sensors respond to red light."),
                              number("green_weight", "", "1", kWeights, "The same for green light."),
                              number("blue_weight", "", "1", kWeights, "The same for blue light.")};
    return description;
  }

  void prepareInstance(const Space& space, Instance& instance) override {
    instance.ring = rings_.of(space.entities.model[instance.row], Device::kType, {"light", "proximity"});
  }

  /// Draws for each sensor with light a ray along its direction, up to 10 cm long in proportion to its `value`.
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
  static constexpr double kFarthest = 100.0;  // m
  static constexpr Range kWeights{0.0, 3.0};
  using Sensors = std::array<IlluminatedSensor, RingGeometry<count>::kMost>;

  static Parameter ledRange() {
    return number("led_range", "m", "0", {0.0, kFarthest},
                  "The same for LEDs of robots, if it is less than `range`; 0: LEDs give no light.");
  }

  /// Entities that shine on a ring. The list is kept between calls so that a steady state allocates nothing.
  const std::vector<Row>& shiningOn(const Space& space, const Instance& instance) const {
    thread_local std::vector<Row> near;
    lit_.collect(space, instance.row, centreOf(space, instance), instance.ring->radius, reach_, near);
    return near;
  }

  static Eigen::Vector3d centreOf(const Space& space, const Instance& instance) {
    return space.entities.pose[instance.row].toWorld(instance.ring->centre);
  }

  /// @param sensors output: positions and directions
  IlluminatedRing placedRing(const Space& space, const Instance& instance, Sensors& sensors) const {
    const RingGeometry<count>& ring = *instance.ring;
    const Pose& pose = space.entities.pose[instance.row];
    IlluminatedRing placed;
    placed.self = instance.row;
    placed.centre = pose.toWorld(ring.centre);
    placed.radius = ring.radius;
    placed.lowest = kInfinity;
    placed.highest = -kInfinity;
    placed.reach = reach_;
    placed.response = response_;
    placed.sensors = {sensors.data(), ring.size()};
    const Eigen::Matrix3d turn = pose.orientation.toRotationMatrix();
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const auto column = static_cast<Eigen::Index>(i);
      sensors[i].position = pose.position + turn * ring.from.col(column);
      sensors[i].direction = turn * ring.direction.col(column);
      placed.lowest = std::min(placed.lowest, sensors[i].position.z());
      placed.highest = std::max(placed.highest, sensors[i].position.z());
    }
    return placed;
  }

  void senseOne(const Space& space, Instance& instance, LightSearch& search) const {
    const std::size_t size = instance.ring->size();
    const std::vector<Row>& near = shiningOn(space, instance);
    if (near.empty()) {  // true for most robots of a large world
      const float dark = Ring::response(0.0);
      for (std::size_t i = 0; i < size; ++i) {
        Ring::valueOf(instance, i) = dark;
      }
      return;
    }
    Sensors sensors;
    std::array<double, RingGeometry<count>::kMost> sums;
    std::fill_n(sums.begin(), size, 0.0);
    search.find(space, placedRing(space, instance, sensors), near).addTo(sums.data());
    for (std::size_t i = 0; i < size; ++i) {
      Ring::valueOf(instance, i) = Ring::response(sums[i]);
    }
  }

  LightReach reach_;
  SpectralResponse response_;
  LitEntities lit_;  // of this tick
  Rings<count> rings_;
};

}  // namespace swarmanoid::devices
