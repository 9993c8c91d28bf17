// An eyebot's distance sensors measure walls, ceiling and floor of the world.
#include "swarmanoid_interface/devices/eyebot_distance.hpp"

#include "../mock_device.hpp"

namespace swarmanoid::mock {
namespace {

class MockEyebotDistance final : public MockDevice {
 public:
  MockEyebotDistance(EyebotDistance& readings, MockState& /*state*/) : readings_(readings) {}

  void sense(const MockState& state) override {
    constexpr Range kRange = EyebotDistance::kUsualRange;
    for (std::size_t i = 0; i < EyebotDistance::kAround; ++i) {
      const double way = wayToWall(state.world, state.pose, EyebotDistance::angle(i), EyebotDistance::kRingRadius);
      readings_.around[i] = Distance::reading(way, kRange);
    }
    const double height = state.pose.position.z();
    readings_.up = Distance::reading(state.world.ceiling - height - EyebotDistance::kUpHeight, kRange);
    readings_.down = Distance::reading(height + EyebotDistance::kDownHeight, kRange);
  }

 private:
  EyebotDistance& readings_;
};

REGISTER_MOCK_DEVICE(EyebotDistance, MockEyebotDistance)

}  // namespace
}  // namespace swarmanoid::mock
