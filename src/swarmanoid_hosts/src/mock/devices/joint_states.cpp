// The encoders of the joints of any robot.
#include <vector>

#include "../mock_device.hpp"
#include "swarmanoid_interface/devices/joints.hpp"

namespace swarmanoid::mock {
namespace {

class MockJointStates final : public MockDevice {
 public:
  MockJointStates(JointStates& readings, MockState& state) : joints_(state.world.joints.count) {
    readings.joints = joints_;
  }

  void sense(const MockState& state) override {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      const Joint joint = state.joint(World::Joints::name(i));
      joints_[i] = {joint.angle, joint.speed, 0.0};
    }
  }

 private:
  std::vector<JointStates::Joint> joints_;
};

REGISTER_MOCK_DEVICE(JointStates, MockJointStates)

}  // namespace
}  // namespace swarmanoid::mock
