// The position of any robot, in a world whose origin is the robot's start.
#include "swarmanoid_interface/devices/positioning.hpp"

#include "../mock_device.hpp"

namespace swarmanoid::mock {
namespace {

class MockPositioning final : public MockDevice {
 public:
  MockPositioning(Positioning& readings, MockState& /*state*/) : readings_(readings) {}

  void sense(const MockState& state) override {
    readings_ = {state.pose.position, 0.0, 0.0, wrapAngle(state.pose.yaw)};
  }

 private:
  Positioning& readings_;
};

REGISTER_MOCK_DEVICE(Positioning, MockPositioning)

}  // namespace
}  // namespace swarmanoid::mock
