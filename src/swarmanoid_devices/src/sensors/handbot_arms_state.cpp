// Encoders and torque sensors of the arms' joints.
#include "mechanisms.hpp"
#include "parameters.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"
#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid::devices {
namespace {

struct ArmsStateInstance : BasicSensorInstance<HandbotArmsState> {
  std::array<int, HandbotArmsState::kJoints> joints{};  ///< indices in the model
};

class HandbotArmsStateSensor final : public SensorOf<HandbotArmsState, ArmsStateInstance> {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = HandbotArmsState::kType;
    description.implementation = "default";
    description.is_default = true;
    description.summary = "Angle, speed and effort of each joint of the arms.";
    description.parameters = {angle("noise", "0", {0.0, 10.0}, "Standard deviation added to each angle that is read.")};
    return description;
  }

  void configure(const Configuration& parameters) override {
    addErrorAlias("gaussian", "joints[].angle", "deviation", parameters.angle("noise", 0.0));
  }

  void sense(const Space& space, std::size_t first, std::size_t last) override {
    for (std::size_t k = first; k < last; ++k) {
      ArmsStateInstance& instance = instances_[k];
      for (std::size_t i = 0; i < HandbotArmsState::kJoints; ++i) {
        if (instance.joints[i] < 0) {
          continue;
        }
        const JointState& state = space.joints[instance.row][instance.joints[i]];
        instance.readings->joints[i] = {state.angle, state.speed, state.effort};
      }
    }
  }

 protected:
  void prepareInstance(const Space& space, ArmsStateInstance& instance) override {
    const EntityModel& model = *space.entities.model[instance.row];
    instance.joints = indicesOf(HandbotArmsState::kNames, model);
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::HandbotArmsStateSensor)
