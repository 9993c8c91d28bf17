// The ground sensors of any robot whose description has them.
#include "swarmanoid_interface/devices/ground.hpp"

#include "common/span_readings.hpp"
#include "printed_floor.hpp"

namespace swarmanoid::devices {
namespace {

using RoomyGroundInstance = SpanReadings<GroundInstance<Ground, Eigen::Dynamic>, GroundSpot>;

class GroundSensor : public GroundSpotsSensor<GroundSensor, Ground, Eigen::Dynamic, RoomyGroundInstance> {
  using Base = GroundSpotsSensor<GroundSensor, Ground, Eigen::Dynamic, RoomyGroundInstance>;

 public:
  static PluginDescription describe() {
    return describeSpots("Infrared spots where the robot has them; the mean of the channels of the floor's colour.");
  }

  static float& valueOf(Instance& instance, std::size_t spot) { return instance.buffer[spot].value; }

 protected:
  std::size_t mostElements() const override { return Ground::kMostSpots; }

  void prepareInstance(const Space& space, Instance& instance) override {
    Base::prepareInstance(space, instance);
    instance.readings->sensors = instance.makeRoom(instance.ring->size());
    for (std::size_t i = 0; i < instance.buffer.size(); ++i) {
      const Eigen::Vector3d place = instance.ring->from.col(static_cast<Eigen::Index>(i));
      instance.buffer[i] = {0.0F, static_cast<float>(place.x()), static_cast<float>(place.y())};
    }
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_GROUND_SENSOR(swarmanoid::devices::GroundSensor)
