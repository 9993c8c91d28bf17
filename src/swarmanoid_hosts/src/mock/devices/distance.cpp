// The distance sensors of any robot measure the walls of the world, from a ring that the world's values describe.
#include "swarmanoid_interface/devices/distance.hpp"

#include <vector>

#include "../mock_device.hpp"

namespace swarmanoid::mock {
namespace {

class MockDistance final : public MockDevice {
 public:
  MockDistance(Distance& readings, MockState& /*state*/) : readings_(readings) {}

  void sense(const MockState& state) override {
    const World::Ring& ring = state.world.ring;
    sensors_.resize(ring.sensors);
    for (std::size_t i = 0; i < ring.sensors; ++i) {
      const double angle = ring.angle(i);
      const double way = wayToWall(state.world, state.pose, angle, ring.radius);
      sensors_[i] = {Distance::reading(way, Distance::kUsualRange), static_cast<float>(angle), 0.0F};
    }
    readings_.sensors = sensors_;
  }

 private:
  Distance& readings_;
  std::vector<DistanceReading> sensors_;
};

REGISTER_MOCK_DEVICE(Distance, MockDistance)

}  // namespace
}  // namespace swarmanoid::mock
