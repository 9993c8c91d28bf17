// The infrared distance sensors of any robot whose description has them.
#include "swarmanoid_interface/devices/distance.hpp"

#include <cmath>

#include "common/span_readings.hpp"
#include "distance_ring.hpp"
#include "surroundings/color_blob_finder.hpp"

namespace swarmanoid::devices {
namespace {

using RoomyDistanceInstance = SpanReadings<DistanceInstance<Distance, Eigen::Dynamic>, DistanceReading>;

class DistanceSensor : public DistanceRingSensor<DistanceSensor, Distance, Eigen::Dynamic, RoomyDistanceInstance> {
  using Base = DistanceRingSensor<DistanceSensor, Distance, Eigen::Dynamic, RoomyDistanceInstance>;

 public:
  static PluginDescription describe() {
    return describeRing("Infrared sensors where the robot has them; distance straight ahead.", Distance::kUsualRange);
  }

  static float& valueOf(RoomyDistanceInstance& instance, std::size_t sensor) {
    return instance.buffer[sensor].distance;
  }

 protected:
  std::size_t mostElements() const override { return Distance::kMostSensors; }

  void prepareInstance(const Space& space, RoomyDistanceInstance& instance) override {
    Base::prepareInstance(space, instance);
    instance.readings->sensors = instance.makeRoom(instance.ring->size());
    for (std::size_t i = 0; i < instance.buffer.size(); ++i) {
      const Eigen::Vector3d direction = instance.ring->direction.col(static_cast<Eigen::Index>(i));
      const double level = direction.head<2>().norm();
      constexpr double kUpright = 1e-9;  // vertical directions have no bearing
      instance.buffer[i].angle = level < kUpright ? 0.0F : toBearing(std::atan2(direction.y(), direction.x()));
      instance.buffer[i].elevation = static_cast<float>(std::atan2(direction.z(), level));
    }
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_RING(swarmanoid::devices::DistanceSensor)
