// Arms: angles are limited to the stops of the joints. The engine that moves the robot moves the joints.
#include "swarmanoid_interface/devices/handbot_arms.hpp"

#include <algorithm>

#include "mechanisms.hpp"
#include "parameters.hpp"
#include "swarmanoid_space/actuator.hpp"

namespace swarmanoid::devices {
namespace {

struct ArmsInstance : BasicActuatorInstance<HandbotArms> {
  std::shared_ptr<const EntityModel> model;
  std::array<int, HandbotArmsState::kJoints> joints{};  // indices in the model
};

/// In the order of HandbotArmsState::kNames.
std::array<double*, HandbotArmsState::kJoints> anglesOf(HandbotArms& arms) {
  return {&arms.left.shoulder,  &arms.left.elbow,  &arms.left.wrist,
          &arms.right.shoulder, &arms.right.elbow, &arms.right.wrist};
}

class HandbotArmsActuator final : public ActuatorOf<HandbotArms, ArmsInstance> {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = HandbotArms::kType;
    description.implementation = "default";
    description.is_default = true;
    description.mechanisms = joints(HandbotArmsState::kNames);
    description.summary = "Angles of the joints of both arms, limited to where they stop.";
    description.parameters = {angle("noise", "0", {0.0, 90.0},
                                    "Standard deviation added to each angle that is commanded, in each tick anew.")};
    return description;
  }

  void configure(const Configuration& parameters) override {
    addErrorAlias("gaussian", "", "deviation", parameters.angle("noise", 0.0));
  }

 protected:
  void prepareInstance(const Space& space, ArmsInstance& instance) override {
    instance.model = space.entities.model[instance.row];
    instance.joints = indicesOf(HandbotArmsState::kNames, *instance.model);
  }

  void limit(const Space& /*space*/, ArmsInstance& instance) override {
    const auto angles = anglesOf(*instance.actuation);
    for (std::size_t i = 0; i < angles.size(); ++i) {
      if (instance.joints[i] >= 0) {
        const EntityModel::Joint& joint = instance.model->joints[static_cast<std::size_t>(instance.joints[i])];
        *angles[i] = std::clamp(*angles[i], joint.lower, joint.upper);
      }
    }
  }

  void apply(Space& space, ArmsInstance& instance) override {
    const auto angles = anglesOf(*instance.actuation);
    for (std::size_t i = 0; i < angles.size(); ++i) {
      if (instance.joints[i] >= 0) {
        space.joint_commands[instance.row][static_cast<std::size_t>(instance.joints[i])] = {JointCommand::Mode::kAngle,
                                                                                            *angles[i]};
      }
    }
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::HandbotArmsActuator)
