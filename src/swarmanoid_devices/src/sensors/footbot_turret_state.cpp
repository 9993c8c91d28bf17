// The turret's encoder and the torque of its motor, as written by the engine that moves the robot.
#include "common/joints.hpp"
#include "common/parameters.hpp"
#include "swarmanoid_interface/devices/footbot_turret.hpp"

namespace swarmanoid::devices {
namespace {

class FootbotTurretStateSensor final : public JointSensor<FootbotTurretStateSensor, FootbotTurretState> {
 public:
  static constexpr auto kJoints = kTurretJoint;

  static PluginDescription describe() {
    PluginDescription description;
    description.label = FootbotTurretState::kType;
    description.implementation = "default";
    description.is_default = true;
    description.mechanisms = joints(kJoints);
    description.summary = "Where the turret stands, how fast it turns, and the torque of its motor.";
    description.parameters = {
        angle("noise", "0", {0.0, 10.0}, "Standard deviation added to the angle."),
        number("noise_torque", "N m", "0", {0.0, 10.0}, "Standard deviation added to the torque.")};
    return description;
  }

  static void read(Instance& instance, std::size_t /*which*/, const JointState& state) {
    *instance.readings = {state.angle, state.speed, state.effort};
  }

  void configure(const Configuration& parameters) override {
    addErrorAlias("gaussian", "angle", "deviation", parameters.angle("noise", 0.0));
    addErrorAlias("gaussian", "torque", "deviation", parameters.number("noise_torque", 0.0));
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::FootbotTurretStateSensor)
