// The joints of any robot turn as they are commanded, without stops.
#include "swarmanoid_interface/devices/joints.hpp"

#include "../mock_device.hpp"
#include "../motor.hpp"

namespace swarmanoid::mock {
namespace {

class MockJoints final : public MockDevice {
 public:
  MockJoints(const Joints& command, MockState& /*state*/) : command_(command) {}

  void act(MockState& state, double dt) override {
    const World::Joints& joints = state.world.joints;
    for (std::size_t i = 0; i < joints.count; ++i) {
      turnByMotor(command_.joints[i], joints.fastest, dt, state.joints[World::Joints::name(i)]);
    }
  }

 private:
  const Joints& command_;
};

REGISTER_MOCK_DEVICE(Joints, MockJoints)

}  // namespace
}  // namespace swarmanoid::mock
