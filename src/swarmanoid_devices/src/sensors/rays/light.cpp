// The light sensors of any robot whose description has them.
#include "swarmanoid_interface/devices/light.hpp"

#include "light_ring.hpp"
#include "roomy_ring.hpp"

namespace swarmanoid::devices {
namespace {

using RoomyLightInstance = RoomyInstance<LightInstance<Light, Eigen::Dynamic>, LightReading>;

class LightSensor : public LightRingSensor<LightSensor, Light, Eigen::Dynamic, RoomyLightInstance> {
  using Base = LightRingSensor<LightSensor, Light, Eigen::Dynamic, RoomyLightInstance>;

 public:
  static PluginDescription describe() {
    return describeRing("Light sensors where the robot has them; the light of LEDs by the inverse square law.");
  }

  static float& valueOf(Instance& instance, std::size_t sensor) { return instance.buffer[sensor].value; }

 protected:
  std::size_t mostElements() const override { return Light::kMostSensors; }

  void prepareInstance(const Space& space, Instance& instance) override {
    Base::prepareInstance(space, instance);
    instance.makeRoomForRing();
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_RING(swarmanoid::devices::LightSensor)
