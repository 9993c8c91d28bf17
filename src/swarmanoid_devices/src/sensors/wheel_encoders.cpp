// The encoders of the wheels of any robot with a differential drive.
#include "swarmanoid_interface/devices/wheel_encoders.hpp"

#include "wheel_turn_sensor.hpp"

namespace swarmanoid::devices {
namespace {

class WheelEncodersSensor final : public WheelTurnSensor<WheelEncodersSensor, WheelEncoders> {
 public:
  static PluginDescription describe() { return describeCounter("How far each wheel has turned, and how fast."); }

  static void count(const Space& /*space*/, Instance& instance, const WheelTurns& turned, const WheelTurns& step,
                    double dt) {
    instance.state.left = {turned.left, step.left, step.left / dt};
    instance.state.right = {turned.right, step.right, step.right / dt};
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::WheelEncodersSensor)
