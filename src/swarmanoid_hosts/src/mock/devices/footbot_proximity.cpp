// A footbot's infrared ring senses the walls of the world.
#include "swarmanoid_interface/devices/footbot_proximity.hpp"

#include "../mock_device.hpp"

namespace swarmanoid::mock {
namespace {

class MockFootbotProximity final : public MockDevice {
 public:
  MockFootbotProximity(FootbotProximity& readings, MockState& /*state*/) : readings_(readings) {}

  void sense(const MockState& state) override {
    for (std::size_t i = 0; i < FootbotProximity::kCount; ++i) {
      readings_.value[i] =
          closenessOfWall(state.world, state.pose, FootbotProximity::angle(i), FootbotProximity::kRingRadius);
    }
  }

 private:
  FootbotProximity& readings_;
};

REGISTER_MOCK_DEVICE(FootbotProximity, MockFootbotProximity)

}  // namespace
}  // namespace swarmanoid::mock
