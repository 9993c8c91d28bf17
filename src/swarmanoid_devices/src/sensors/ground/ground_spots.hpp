/// Base class of ground sensors: each spot reads the colour of the floor where its line of sight meets the ground, by a
/// GroundResponse, or 0 if that is beyond the range. The spots are at links of the robot's description, and look along
/// the x axes of the links.
///
/// Engines let bodies penetrate the ground slightly: a spot up to 1 cm below the ground reads the floor there.
///
/// To add ground sensors, write their struct with `std::array<float, kCount> value`, and a class such as
///
///     class MyGroundSensor final : public GroundSpotsSensor<MyGroundSensor, MyGround, MyGround::kCount> {
///      public:
///       static PluginDescription describe() { return describeSpots("3 infrared spots in front."); }
///       static float& valueOf(Instance& instance, std::size_t spot) { return instance.readings->value[spot]; }
///     };
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "common/field_numbers.hpp"
#include "common/parameters.hpp"
#include "sensors/rays/ring_geometry.hpp"
#include "sensors/rays/sampled_ring.hpp"
#include "surroundings/ground_response.hpp"
#include "surroundings/way_to_ground.hpp"
#include "swarmanoid_interface/devices/ground.hpp"
#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid::devices {

static_assert(Ground::kMostSpots == kMostRingSensors);

template <class Device, int count>
struct GroundInstance : BasicSensorInstance<Device> {
  std::shared_ptr<const RingGeometry<count>> ring;

  void archive(StateArchive& /*state*/) {}
};

/// `Spots` derives from this, and has `static float& valueOf(Instance&, std::size_t)`, the reading of a spot. Spots at
/// links with another name define their own `static constexpr const char* kLinks`.
template <class Spots, class Device, int count, class InstanceOfSpots = GroundInstance<Device, count>>
class GroundSpotsSensor : public SensorOf<Device, InstanceOfSpots> {
 public:
  using Instance = InstanceOfSpots;

  static constexpr const char* kLinks = "ground";  ///< the links are ground_0, ground_1, ...

  void configure(const Configuration& parameters) override { range_ = parameters.number("range", Ground::kUsualRange); }

  void sense(const Space& space, std::size_t first, std::size_t last) override {
    const bool is_level = !space.terrain && space.floor.holes.empty();
    LevelReadings level;
    for (std::size_t k = first; k < last; ++k) {
      Instance& instance = this->instances_[k];
      const Pose& pose = space.entities.pose[instance.row];
      if (is_level && pose.isUpright() && space.floor.isBareAround(pose.position, reachOf(*instance.ring, level))) {
        readLevel(space, pose.position.z(), instance, level);
      } else {
        senseOne(space, instance);
      }
    }
  }

  // For the implementation `sampled`.
  static constexpr SampledLaw kSampledLaw{Stimulus::kFloor, {0.0, 1.0}, 0.0};
  double range() const { return range_; }

 protected:
  void setResponse(const GroundResponse& response) { response_ = response; }
  static std::vector<Parameter> parametersBesideTable() { return {}; }
  void setRange(const SampleTable& table, const Configuration& /*parameters*/) {
    range_ = table.farthest() + kSampledMargin;
  }

  template <class Visit>
  void visitFelt(const Space& space, const Instance& instance, Visit visit) const {
    visitGround(space, instance,
                [&](std::size_t i, const Eigen::Vector3d& spot, const Eigen::Vector3d& direction, double way) {
                  const Color color = space.floor.colorAt(spot + way * direction, space.tick);
                  const double tilt = std::atan2(direction.head<2>().norm(), -direction.z());
                  visit(i, std::max(way, 0.0), tilt, static_cast<double>(response_(color)));
                });
  }

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

  /// Draws for each spot that meets the ground its line of sight and the end point, in the grey of its `value`.
  void drawOne(const Space& space, const InstanceOfSpots& instance, DeviceDrawing& drawing) const override {
    const auto& values = numbersOf(this->delivered(instance), "value", instance.ring->size());
    visitGround(space, instance,
                [&](std::size_t i, const Eigen::Vector3d& spot, const Eigen::Vector3d& direction, double way) {
                  const auto grey = static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(values[i], 0.0, 1.0)));
                  drawing.line(spot, spot + way * direction, {grey, grey, grey});
                  drawing.point(spot + way * direction, {grey, grey, grey});
                });
  }

 private:
  static constexpr double kMargin = 1e-6;  // for rounding, m

  /// Calls visit(spot, position in W [m], direction, way to the ground [m]) for each spot that meets the ground.
  template <class Visit>
  void visitGround(const Space& space, const Instance& instance, Visit visit) const {
    const RingGeometry<count>& ring = *instance.ring;
    const Pose& pose = space.entities.pose[instance.row];
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const auto column = static_cast<Eigen::Index>(i);
      const Eigen::Vector3d spot = pose.toWorld(ring.from.col(column));
      const Eigen::Vector3d direction = pose.orientation * ring.direction.col(column);
      const double way = wayToGround(space, spot, direction, range_);
      if (way != kInfinity) {
        visit(i, spot, direction, way);
      }
    }
  }

  /// Readings of an upright ring over a level, bare floor. They depend only on its height, so most robots have the same
  /// readings as the previous robot.
  struct LevelReadings {
    const RingGeometry<count>* ring = nullptr;
    double reach = 0.0;            // of the ring, see reachOf, m
    double height = std::nan("");  // of the robot, m
    std::array<float, RingGeometry<count>::kMost> values;
  };

  /// Distance from the robot's origin to the farthest floor that its spots may see [m].
  double reachOf(const RingGeometry<count>& ring, LevelReadings& level) const {
    if (&ring != level.ring) {
      level.ring = &ring;
      level.reach = ring.centre.norm() + ring.radius + std::max(range_, kDeepestSpot) + kMargin;
      level.height = std::nan("");
    }
    return level.reach;
  }

  /// As senseOne, bit for bit: rotations about z do not change the z of positions and directions.
  void readLevel(const Space& space, double height, Instance& instance, LevelReadings& level) const {
    const RingGeometry<count>& ring = *instance.ring;
    if (height != level.height) {
      level.height = height;
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const auto column = static_cast<Eigen::Index>(i);
        const Eigen::Vector3d spot(0.0, 0.0, ring.from(2, column) + height);
        const Eigen::Vector3d direction(0.0, 0.0, ring.direction(2, column));
        const double way = wayToGround(space, spot, direction, range_);
        level.values[i] = way == kInfinity ? 0.0F : response_(space.floor.bare);
      }
    }
    for (std::size_t i = 0; i < ring.size(); ++i) {
      Spots::valueOf(instance, i) = level.values[i];
    }
  }

  void senseOne(const Space& space, Instance& instance) const {
    const RingGeometry<count>& ring = *instance.ring;
    const Pose& pose = space.entities.pose[instance.row];
    const Eigen::Matrix3d rotation = pose.orientation.toRotationMatrix();
    LevelReadings unused;
    const bool is_bare = space.floor.isBareAround(pose.position, reachOf(ring, unused));
    const float bare = response_(space.floor.bare);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const auto column = static_cast<Eigen::Index>(i);
      const Eigen::Vector3d spot = rotation * ring.from.col(column) + pose.position;
      const Eigen::Vector3d direction = rotation * ring.direction.col(column);
      const double way = wayToGround(space, spot, direction, range_);
      float& value = Spots::valueOf(instance, i);
      if (way == kInfinity || is_bare) {
        value = way == kInfinity ? 0.0F : bare;
      } else {
        value = response_(space.floor.colorAt(spot + way * direction, space.tick));
      }
    }
  }

  double range_ = Ground::kUsualRange;
  GroundResponse response_;
  Rings<count> rings_;
};

}  // namespace swarmanoid::devices
