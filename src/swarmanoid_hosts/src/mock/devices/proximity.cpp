// The infrared sensors of any robot sense the walls of the world, from a ring that the world's values describe.
#include "swarmanoid_interface/devices/proximity.hpp"

#include <vector>

#include "../mock_device.hpp"

namespace swarmanoid::mock {
namespace {

class MockProximity final : public MockDevice {
 public:
  MockProximity(Proximity& readings, MockState& /*state*/) : readings_(readings) {}

  void sense(const MockState& state) override {
    const World::Ring& ring = state.world.ring;
    sensors_.resize(ring.sensors);
    for (std::size_t i = 0; i < ring.sensors; ++i) {
      const double angle = ring.angle(i);
      sensors_[i] = {closenessOfWall(state.world, state.pose, angle, ring.radius), static_cast<float>(angle)};
    }
    readings_.sensors = sensors_;
  }

 private:
  Proximity& readings_;
  std::vector<ProximityReading> sensors_;
};

REGISTER_MOCK_DEVICE(Proximity, MockProximity)

}  // namespace
}  // namespace swarmanoid::mock
