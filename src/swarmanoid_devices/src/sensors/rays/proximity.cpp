// The infrared proximity sensors of any robot whose description has them.
#include "swarmanoid_interface/devices/proximity.hpp"

#include "proximity_ring.hpp"
#include "roomy_ring.hpp"

namespace swarmanoid::devices {
namespace {

using RoomyProximityInstance = RoomyInstance<ProximityInstance<Proximity, Eigen::Dynamic>, ProximityReading>;

class ProximitySensor : public ProximityRingSensor<ProximitySensor, Proximity, Eigen::Dynamic, RoomyProximityInstance> {
  using Base = ProximityRingSensor<ProximitySensor, Proximity, Eigen::Dynamic, RoomyProximityInstance>;

 public:
  static PluginDescription describe() {
    return describeRing("Infrared sensors where the robot has them; a cubic polynomial of the distance.");
  }

  static float& valueOf(RoomyProximityInstance& instance, std::size_t sensor) { return instance.buffer[sensor].value; }

 protected:
  std::size_t mostElements() const override { return Proximity::kMostSensors; }

  void prepareInstance(const Space& space, RoomyProximityInstance& instance) override {
    Base::prepareInstance(space, instance);
    instance.makeRoomForRing();
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_RING(swarmanoid::devices::ProximitySensor)
