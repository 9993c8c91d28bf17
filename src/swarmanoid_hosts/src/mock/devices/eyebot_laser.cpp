// An eyebot's laser pointer makes a red spot on the ground.
#include "swarmanoid_interface/devices/eyebot_laser.hpp"

#include <cmath>

#include "../mock_device.hpp"

namespace swarmanoid::mock {
namespace {

class MockEyebotLaser final : public MockDevice {
 public:
  MockEyebotLaser(const EyebotLaser& command, MockState& /*state*/) : command_(command) {}

  void follow(MockState& state) override {
    state.spots.erase(EyebotLaser::kType);
    if (!command_.on) {
      return;
    }
    EyebotLaser laser = command_;
    limitToRanges(laser);
    const auto& [x, y, z] = EyebotLaser::kMount;
    const double way = (state.pose.position.z() + z) * std::tan(laser.tilt);
    Eigen::Vector3d spot = state.pose.toWorld({x + way * std::cos(laser.pan), y + way * std::sin(laser.pan), 0.0});
    spot.z() = 0.0;
    state.spots[EyebotLaser::kType] = {"spot", spot, colors::kRed};
  }

 private:
  const EyebotLaser& command_;
};

REGISTER_MOCK_DEVICE(EyebotLaser, MockEyebotLaser)

}  // namespace
}  // namespace swarmanoid::mock
