// The ground sensors of any robot read the discs on the floor of the world, from the ring that the world's values
// describe.
#include "swarmanoid_interface/devices/ground.hpp"

#include <cmath>
#include <vector>

#include "../mock_device.hpp"

namespace swarmanoid::mock {
namespace {

class MockGround final : public MockDevice {
 public:
  MockGround(Ground& readings, MockState& /*state*/) : readings_(readings) {}

  void sense(const MockState& state) override {
    const World::Ring& ring = state.world.ring;
    spots_.resize(ring.sensors);
    for (std::size_t i = 0; i < ring.sensors; ++i) {
      const double angle = ring.angle(i);
      const Eigen::Vector2d place(ring.radius * std::cos(angle), ring.radius * std::sin(angle));
      spots_[i] = {reflectionUnder(state.world, state.pose, place), static_cast<float>(place.x()),
                   static_cast<float>(place.y())};
    }
    readings_.sensors = spots_;
  }

 private:
  Ground& readings_;
  std::vector<GroundSpot> spots_;
};

REGISTER_MOCK_DEVICE(Ground, MockGround)

}  // namespace
}  // namespace swarmanoid::mock
