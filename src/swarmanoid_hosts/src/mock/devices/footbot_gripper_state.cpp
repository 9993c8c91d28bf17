// The contact switch of a footbot's gripper.
#include "../mock_device.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"

namespace swarmanoid::mock {
namespace {

class MockFootbotGripperState final : public MockDevice {
 public:
  MockFootbotGripperState(FootbotGripperState& readings, MockState& /*state*/) : readings_(readings) {}

  void sense(const MockState& state) override { readings_.gripping = state.holder("gripper").is_holding; }

 private:
  FootbotGripperState& readings_;
};

REGISTER_MOCK_DEVICE(FootbotGripperState, MockFootbotGripperState)

}  // namespace
}  // namespace swarmanoid::mock
