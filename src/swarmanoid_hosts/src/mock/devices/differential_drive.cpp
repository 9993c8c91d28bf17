// The wheels of any robot drive it over flat ground, and through walls, as fast as they are commanded.
#include "swarmanoid_interface/devices/differential_drive.hpp"

#include "../mock_device.hpp"

namespace swarmanoid::mock {
namespace {

class MockDifferentialDrive final : public MockDevice {
 public:
  MockDifferentialDrive(const DifferentialDrive& command, MockState& /*state*/) : command_(command) {}

  void act(MockState& state, double /*dt*/) override {
    state.twist.linear = {command_.speed, 0.0, 0.0};
    state.twist.yaw_rate = command_.turn_rate;
  }

 private:
  const DifferentialDrive& command_;
};

REGISTER_MOCK_DEVICE(DifferentialDrive, MockDifferentialDrive)

}  // namespace
}  // namespace swarmanoid::mock
