// A handbot's arms follow their commands at the joints' maximum speed, within the joints' limits.
#include "swarmanoid_interface/devices/handbot_arms.hpp"

#include "../mock_device.hpp"

namespace swarmanoid::mock {
namespace {

class MockHandbotArms final : public MockDevice {
 public:
  MockHandbotArms(const HandbotArms& command, MockState& /*state*/) : command_(command) {}

  void act(MockState& state, double dt) override {
    HandbotArms arms = command_;
    limitToRanges(arms);
    const std::array<double, HandbotArmsState::kJoints> wanted{arms.left.shoulder,  arms.left.elbow,  arms.left.wrist,
                                                               arms.right.shoulder, arms.right.elbow, arms.right.wrist};
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      Joint& joint = state.joints[HandbotArmsState::kNames[i]];
      joint.turn(wanted[i] - joint.angle, HandbotArms::kFastest, dt);
    }
  }

 private:
  const HandbotArms& command_;
};

REGISTER_MOCK_DEVICE(HandbotArms, MockHandbotArms)

}  // namespace
}  // namespace swarmanoid::mock
