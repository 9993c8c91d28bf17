// The odometry of any robot, which is exact until the robot is placed elsewhere.
#include "swarmanoid_interface/devices/odometry.hpp"

#include "../rolling.hpp"

namespace swarmanoid::mock {
namespace {

class MockOdometry final : public RollingDevice<Odometry> {
 public:
  MockOdometry(Odometry& readings, MockState& /*state*/) : RollingDevice(readings) {}

 protected:
  void roll(double left, double right, const World::Wheels& wheels, double dt) override {
    readings_.roll({left, 0.0}, {right, 0.0}, wheels.separation, dt);
  }
};

REGISTER_MOCK_DEVICE(Odometry, MockOdometry)

}  // namespace
}  // namespace swarmanoid::mock
