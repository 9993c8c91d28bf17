// Arms: angles are limited to the stops of the joints. The engine that moves the robot moves the joints.
#include "swarmanoid_interface/devices/handbot_arms.hpp"

#include "common/joints.hpp"
#include "common/parameters.hpp"

namespace swarmanoid::devices {
namespace {

class HandbotArmsActuator final : public JointActuator<HandbotArmsActuator, HandbotArms, HandbotArmsState::kJoints> {
 public:
  static constexpr auto kJoints = HandbotArmsState::kNames;

  static PluginDescription describe() {
    PluginDescription description;
    description.label = HandbotArms::kType;
    description.implementation = "default";
    description.is_default = true;
    description.mechanisms = joints(kJoints);
    description.summary = "Angles of the joints of both arms, limited to where they stop.";
    description.parameters = {angle("noise", "0", {0.0, 90.0},
                                    "Standard deviation added to each angle that is commanded, in each tick anew.")};
    return description;
  }

  static JointTarget targetOf(HandbotArms& arms, std::size_t which) {
    const std::array<double*, kJoints.size()> angles{&arms.left.shoulder,  &arms.left.elbow,  &arms.left.wrist,
                                                     &arms.right.shoulder, &arms.right.elbow, &arms.right.wrist};
    return {JointCommand::Mode::kAngle, angles[which]};
  }

  void configure(const Configuration& parameters) override {
    addErrorAlias("gaussian", "", "deviation", parameters.angle("noise", 0.0));
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::HandbotArmsActuator)
