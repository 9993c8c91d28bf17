// The ground sensors of any robot, where its description has them.
#include "swarmanoid_interface/devices/ground.hpp"

#include <vector>

#include "ground_spots.hpp"

namespace swarmanoid::devices {
namespace {

struct RoomyGroundInstance : GroundInstance<Ground, Eigen::Dynamic> {
  std::vector<GroundSpot> buffer;  // it stays where it is when the instance moves
};

class GroundSensor final : public GroundSpotsSensor<GroundSensor, Ground, Eigen::Dynamic, RoomyGroundInstance> {
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
    for (Eigen::Index i = 0; i < instance.ring->from.cols(); ++i) {
      const Eigen::Vector3d place = instance.ring->from.col(i);
      instance.buffer.push_back({0.0F, static_cast<float>(place.x()), static_cast<float>(place.y())});
    }
    instance.readings->spots = Span<const GroundSpot>(instance.buffer.data(), instance.buffer.size());
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::GroundSensor)
