// The docking sensors of a handbot's hands.
#include "../mock_device.hpp"
#include "swarmanoid_interface/devices/handbot_hands.hpp"

namespace swarmanoid::mock {
namespace {

class MockHandbotHandsState final : public MockDevice {
 public:
  MockHandbotHandsState(HandbotHandsState& readings, MockState& /*state*/) : readings_(readings) {}

  void sense(const MockState& state) override {
    const Holder left = state.holder("left hand");
    const Holder right = state.holder("right hand");
    readings_.left = {left.is_holding, left.force};
    readings_.right = {right.is_holding, right.force};
  }

 private:
  HandbotHandsState& readings_;
};

REGISTER_MOCK_DEVICE(HandbotHandsState, MockHandbotHandsState)

}  // namespace
}  // namespace swarmanoid::mock
