// Encoders and torque sensors of the arms' joints.
#include "common/joints.hpp"
#include "common/parameters.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"

namespace swarmanoid::devices {
namespace {

class HandbotArmsStateSensor final
    : public JointSensor<HandbotArmsStateSensor, HandbotArmsState, HandbotArmsState::kJoints> {
 public:
  static constexpr auto kJoints = HandbotArmsState::kNames;

  static PluginDescription describe() {
    PluginDescription description;
    description.label = HandbotArmsState::kType;
    description.implementation = "default";
    description.is_default = true;
    description.summary = "Angle, speed and effort of each joint of the arms.";
    description.parameters = {angle("noise", "0", {0.0, 10.0}, "Standard deviation added to each angle that is read.")};
    return description;
  }

  static void read(Instance& instance, std::size_t which, const JointState& state) {
    instance.readings->joints[which] = {state.angle, state.speed, state.effort};
  }

  void configure(const Configuration& parameters) override {
    addErrorAlias("gaussian", "joints[].angle", "deviation", parameters.angle("noise", 0.0));
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::HandbotArmsStateSensor)
