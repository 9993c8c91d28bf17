// The encoders of a handbot's arms.
#include "../mock_device.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"

namespace swarmanoid::mock {
namespace {

class MockHandbotArmsState final : public MockDevice {
 public:
  MockHandbotArmsState(HandbotArmsState& readings, MockState& /*state*/) : readings_(readings) {}

  void sense(const MockState& state) override {
    for (std::size_t i = 0; i < HandbotArmsState::kJoints; ++i) {
      const Joint joint = state.joint(HandbotArmsState::kNames[i]);
      readings_.joints[i] = {joint.angle, joint.speed, 0.0};
    }
  }

 private:
  HandbotArmsState& readings_;
};

REGISTER_MOCK_DEVICE(HandbotArmsState, MockHandbotArmsState)

}  // namespace
}  // namespace swarmanoid::mock
