// The encoders of the wheels of any robot.
#include "swarmanoid_interface/devices/wheel_encoders.hpp"

#include "../rolling.hpp"

namespace swarmanoid::mock {
namespace {

class MockWheelEncoders final : public RollingDevice<WheelEncoders> {
 public:
  MockWheelEncoders(WheelEncoders& readings, MockState& /*state*/) : RollingDevice(readings) {}

 protected:
  void roll(double left, double right, const World::Wheels& wheels, double dt) override {
    turn(readings_.left, left / wheels.radius, dt);
    turn(readings_.right, right / wheels.radius, dt);
  }

 private:
  static void turn(WheelEncoders::Wheel& wheel, double step, double dt) {
    wheel = {wheel.turned + step, step, step / dt};
  }
};

REGISTER_MOCK_DEVICE(WheelEncoders, MockWheelEncoders)

}  // namespace
}  // namespace swarmanoid::mock
