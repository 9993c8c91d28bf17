// A handbot's distance sensors measure the walls of the world.
#include "swarmanoid_interface/devices/handbot_distance.hpp"

#include "../mock_device.hpp"

namespace swarmanoid::mock {
namespace {

class MockHandbotDistance final : public MockDevice {
 public:
  MockHandbotDistance(HandbotDistance& readings, MockState& /*state*/) : readings_(readings) {}

  void sense(const MockState& state) override {
    for (std::size_t i = 0; i < HandbotDistance::kCount; ++i) {
      const double way = wayToWall(state.world, state.pose, HandbotDistance::angle(i), HandbotDistance::kRingRadius);
      readings_.value(i) = Distance::reading(way, HandbotDistance::kUsualRange);
    }
  }

 private:
  HandbotDistance& readings_;
};

REGISTER_MOCK_DEVICE(HandbotDistance, MockHandbotDistance)

}  // namespace
}  // namespace swarmanoid::mock
