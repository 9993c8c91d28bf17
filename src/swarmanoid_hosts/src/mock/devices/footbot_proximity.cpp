// A footbot's infrared ring feels the walls of the world.
#include "swarmanoid_interface/devices/footbot_proximity.hpp"

#include <algorithm>

#include "../mock_device.hpp"
#include "swarmanoid_interface/devices/proximity.hpp"

namespace swarmanoid::mock {
namespace {

class MockFootbotProximity final : public MockDevice {
 public:
  MockFootbotProximity(FootbotProximity& readings, MockState& /*state*/) : readings_(readings) {}

  void sense(const MockState& state) override {
    for (std::size_t i = 0; i < FootbotProximity::kCount; ++i) {
      const double direction = state.pose.yaw + FootbotProximity::angle(i);
      const double distance =
          distanceToWall(state.world, state.pose.position.head<2>(), direction) - FootbotProximity::kRingRadius;
      const double fraction = std::clamp(distance / Proximity::kUsualRange, 0.0, 1.0);
      readings_.value[i] = Proximity::response(fraction);
    }
  }

 private:
  FootbotProximity& readings_;
};

REGISTER_MOCK_DEVICE(FootbotProximity, MockFootbotProximity)

}  // namespace
}  // namespace swarmanoid::mock
