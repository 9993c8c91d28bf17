// An eyebot flies to positions by the law of the device. A mock has both flight controllers: the one for velocities is
// in effect while this one is commanded to hover.
#include "swarmanoid_interface/devices/eyebot_position.hpp"

#include "../mock_device.hpp"
#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/devices/eyebot_pilot.hpp"

namespace swarmanoid::mock {
namespace {

class MockEyebotPosition final : public MockDevice {
 public:
  MockEyebotPosition(const EyebotPosition& command, MockState& state) : command_(command) {
    state.top = state.world.ceiling - EyebotMagnet::kMount;
  }

  void act(MockState& state, double dt) override {
    state.flies_to_place = command_.mode != EyebotPosition::Mode::kHover;
    EyebotPilot::Flight flight;
    if (state.flies_to_place) {
      flight = pilot_.fly(command_, {}, dt);
    } else {
      pilot_.rest();
    }
    state.twist.linear = flight.linear;
    state.twist.yaw_rate = flight.yaw_rate;
    before_ = state.pose;
    dt_ = dt;
  }

  void follow(MockState& state) override {
    pilot_.moved(-state.pose.toRobot(before_.position), wrapAngle(state.pose.yaw - before_.yaw), dt_);
  }

 private:
  const EyebotPosition& command_;
  EyebotPilot pilot_;
  Pose before_;
  double dt_ = 0.0;
};

REGISTER_MOCK_DEVICE(EyebotPosition, MockEyebotPosition)

}  // namespace
}  // namespace swarmanoid::mock
