// The infrared sensors of any robot, where its description has them.
#include "swarmanoid_interface/devices/proximity.hpp"

#include <cmath>
#include <vector>

#include "color_blob_finder.hpp"
#include "proximity_ring.hpp"

namespace swarmanoid::devices {
namespace {

struct Instance : ProximityInstance<Proximity, Eigen::Dynamic> {
  std::vector<ProximityReading> buffer;
};

class ProximitySensor final : public ProximityRingSensor<ProximitySensor, Proximity, Eigen::Dynamic, Instance> {
  using Base = ProximityRingSensor<ProximitySensor, Proximity, Eigen::Dynamic, Instance>;

 public:
  static PluginDescription describe() {
    return describeRing("Infrared sensors where the robot has them; a cubic polynomial of the distance.");
  }

  static float& valueOf(Instance& instance, std::size_t sensor) { return instance.buffer[sensor].value; }

 protected:
  std::size_t mostElements() const override { return Proximity::kMostSensors; }

  void prepareInstance(const Space& space, Instance& instance) override {
    Base::prepareInstance(space, instance);
    for (Eigen::Index i = 0; i < instance.ring->direction.cols(); ++i) {
      const Eigen::Vector3d direction = instance.ring->direction.col(i);
      instance.buffer.push_back({0.0F, toBearing(std::atan2(direction.y(), direction.x()))});
    }
    // the buffer stays where it is when the instance moves
    instance.readings->sensors = Span<const ProximityReading>(instance.buffer.data(), instance.buffer.size());
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::ProximitySensor)
