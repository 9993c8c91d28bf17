// The light sensors of any robot, where its description has them.
#include "swarmanoid_interface/devices/light.hpp"

#include <cmath>
#include <vector>

#include "color_blob_finder.hpp"
#include "light_ring.hpp"

namespace swarmanoid::devices {
namespace {

struct RoomyInstance : LightInstance<Light, Eigen::Dynamic> {
  std::vector<LightReading> buffer;
};

class LightSensor final : public LightRingSensor<LightSensor, Light, Eigen::Dynamic, RoomyInstance> {
  using Base = LightRingSensor<LightSensor, Light, Eigen::Dynamic, RoomyInstance>;

 public:
  static PluginDescription describe() {
    return describeRing("Light sensors where the robot has them; the light of LEDs by the inverse square law.");
  }

  static float& valueOf(RoomyInstance& instance, std::size_t sensor) { return instance.buffer[sensor].value; }

 protected:
  std::size_t mostElements() const override { return Light::kMostSensors; }

  void prepareInstance(const Space& space, RoomyInstance& instance) override {
    Base::prepareInstance(space, instance);
    for (Eigen::Index i = 0; i < instance.ring->direction.cols(); ++i) {
      const Eigen::Vector3d direction = instance.ring->direction.col(i);
      instance.buffer.push_back({0.0F, toBearing(std::atan2(direction.y(), direction.x()))});
    }
    // the buffer stays where it is when the instance moves
    instance.readings->sensors = Span<const LightReading>(instance.buffer.data(), instance.buffer.size());
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::LightSensor)
