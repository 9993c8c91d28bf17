/// What all ground sensors have in common: each spot reads the colour of the floor where its line of sight meets the
/// ground, by the law of Ground::reflection, and 0 if that is farther than the range. The spots are where links of the
/// robot's description are, and look along the x axes of these.
///
/// The ground is the level floor, z = 0, and the terrain where there is one: its holes are deep, its slopes are nearer.
/// Engines let bodies sink in by a little: a spot that is pressed into the ground by up to 1 cm reads the floor there.
/// Nothing else hides the floor. On level floor no ray is cast.
///
/// Spots of a robot of its own are its struct with `std::array<float, kCount> value`, and a class such as
///
///     class MyGroundSensor final : public GroundSpotsSensor<MyGroundSensor, MyGround, MyGround::kCount> {
///      public:
///       static PluginDescription describe() { return describeSpots("3 infrared spots in front."); }
///       static float& valueOf(Instance& instance, std::size_t spot) { return instance.readings->value[spot]; }
///     };
#pragma once

#include <algorithm>
#include <memory>
#include <string>

#include "parameters.hpp"
#include "ring_geometry.hpp"
#include "swarmanoid_interface/devices/ground.hpp"
#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid::devices {

static_assert(Ground::kMostSpots == kMostRingSensors);

constexpr double kDeepestSpot = 0.01;  // in the ground, along its line of sight, m

/// How far along its line of sight a spot meets the ground. Thread-safe.
/// @param spot its place in W [m] @param direction in which it looks, in W, of length 1 @param range [m]
/// @return from -kDeepestSpot to range [m]; infinity if it meets none there
inline double wayToGround(const Space& space, const Eigen::Vector3d& spot, const Eigen::Vector3d& direction,
                          double range) {
  double way = direction.z() < 0.0 ? -spot.z() / direction.z() : kInfinity;  // to the level floor
  if (way < -kDeepestSpot || way > range) {
    way = kInfinity;
  }
  if (!space.terrain) {
    return way;
  }
  if (way != kInfinity) {
    const Eigen::Vector3d point = spot + way * direction;
    way = space.terrain->contains(point.x(), point.y()) ? kInfinity : way;
  }
  const double fraction = space.terrain->closestHit({spot - kDeepestSpot * direction, spot + range * direction});
  return fraction <= 1.0 ? std::min(way, fraction * (kDeepestSpot + range) - kDeepestSpot) : way;
}

template <class Device, int count>
struct GroundInstance : BasicSensorInstance<Device> {
  std::shared_ptr<const RingGeometry<count>> ring;
};

/// `Spots` derives from this, and has `static float& valueOf(Instance&, std::size_t)`, where the reading of a spot is.
/// Spots at links of another name have a `static constexpr const char* kLinks` of their own.
template <class Spots, class Device, int count, class InstanceOfSpots = GroundInstance<Device, count>>
class GroundSpotsSensor : public SensorOf<Device, InstanceOfSpots> {
 public:
  using Instance = InstanceOfSpots;

  static constexpr const char* kLinks = "ground";  ///< the links are ground_0, ground_1, ...

  void configure(const Configuration& parameters) override { range_ = parameters.number("range", Ground::kUsualRange); }

  void sense(const Space& space, std::size_t first, std::size_t last) override {
    for (std::size_t k = first; k < last; ++k) {
      senseOne(space, this->instances_[k]);
    }
  }

 protected:
  static PluginDescription describeSpots(const std::string& summary) {
    PluginDescription description;
    description.label = Device::kType;
    description.implementation = "brightness";
    description.is_default = true;
    description.summary = summary;
    description.parameters = {number("range", "m", numberText(Ground::kUsualRange), {0.001, 1.0},
                                     "Distance beyond which there is no ground for a spot.")};
    return description;
  }

  void prepareInstance(const Space& space, Instance& instance) override {
    instance.ring = rings_.of(space.entities.model[instance.row], Device::kType, {Spots::kLinks});
  }

 private:
  void senseOne(const Space& space, Instance& instance) const {
    const RingGeometry<count>& ring = *instance.ring;
    const Pose& pose = space.entities.pose[instance.row];
    const Eigen::Matrix3d rotation = pose.orientation.toRotationMatrix();
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const auto column = static_cast<Eigen::Index>(i);
      const Eigen::Vector3d spot = rotation * ring.from.col(column) + pose.position;
      const Eigen::Vector3d direction = rotation * ring.direction.col(column);
      const double way = wayToGround(space, spot, direction, range_);
      Spots::valueOf(instance, i) =
          way == kInfinity ? 0.0F : Ground::reflection(space.floor.colorAt(spot + way * direction, space.tick));
    }
  }

  double range_ = Ground::kUsualRange;
  Rings<count> rings_;
};

}  // namespace swarmanoid::devices
