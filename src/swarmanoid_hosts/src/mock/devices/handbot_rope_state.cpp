// The rope's encoder and tension sensor.
#include "../mock_device.hpp"
#include "swarmanoid_interface/devices/handbot_rope.hpp"

namespace swarmanoid::mock {
namespace {

class MockHandbotRopeState final : public MockDevice {
 public:
  MockHandbotRopeState(HandbotRopeState& readings, MockState& /*state*/) : readings_(readings) {}

  void sense(const MockState& state) override {
    const Holder rope = state.holder("rope");
    readings_ = {rope.is_holding, rope.length, rope.force};
  }

 private:
  HandbotRopeState& readings_;
};

REGISTER_MOCK_DEVICE(HandbotRopeState, MockHandbotRopeState)

}  // namespace
}  // namespace swarmanoid::mock
