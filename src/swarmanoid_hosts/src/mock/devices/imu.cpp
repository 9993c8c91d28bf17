// The inertial measurement unit of any robot, which moves at a steady pace on level ground.
#include "swarmanoid_interface/devices/imu.hpp"

#include "../mock_device.hpp"

namespace swarmanoid::mock {
namespace {

class MockImu final : public MockDevice {
 public:
  MockImu(Imu& readings, MockState& /*state*/) : readings_(readings) {}

  void sense(const MockState& state) override {
    const Imu::Motion motion{state.twist.linear, {0.0, 0.0, state.twist.yaw_rate}, Eigen::Vector3d::UnitZ()};
    constexpr double kAnyTime = 1.0;  // [s]; has no effect, since the motion is the same before and after
    readings_ = Imu::reading(motion, motion, kAnyTime);
  }

 private:
  Imu& readings_;
};

REGISTER_MOCK_DEVICE(Imu, MockImu)

}  // namespace
}  // namespace swarmanoid::mock
