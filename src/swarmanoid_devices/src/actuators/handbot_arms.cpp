// Arms: angles are limited to the stops of the joints. The engine that moves the robot moves the joints.
#include "swarmanoid_interface/devices/handbot_arms.hpp"

#include <algorithm>

#include "parameters.hpp"
#include "swarmanoid_space/actuator.hpp"

namespace swarmanoid::devices {
namespace {

struct ArmsInstance : BasicActuatorInstance<HandbotArms> {
  std::shared_ptr<const EntityModel> model;
};

class HandbotArmsActuator final : public ActuatorOf<HandbotArms, ArmsInstance> {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = HandbotArms::kType;
    description.implementation = "default";
    description.is_default = true;
    description.summary = "Angles of the joints of both arms, limited to where they stop.";
    description.robots = {"handbot"};
    description.parameters = {
        angle("noise", "0", {0.0, 90.0}, "Standard deviation added to each angle that is commanded.")};
    return description;
  }

  void configure(const Configuration& parameters) override { noise_ = parameters.angle("noise", 0.0); }

 protected:
  void prepareInstance(const Space& space, ArmsInstance& instance) override {
    instance.model = space.entities.model[static_cast<std::size_t>(instance.row)];
  }

  void limit(const Space& space, ArmsInstance& instance) override {
    instance.random.startTick(space.tick);
    const std::array<double*, HandbotArmsState::kJoints> angles{
        &instance.actuation->left.shoulder,  &instance.actuation->left.elbow,  &instance.actuation->left.wrist,
        &instance.actuation->right.shoulder, &instance.actuation->right.elbow, &instance.actuation->right.wrist};
    for (std::size_t i = 0; i < angles.size(); ++i) {
      if (noise_ > 0.0) {
        *angles[i] += instance.random.gaussian(0.0, noise_);
      }
      const int index = instance.model->findJoint(HandbotArmsState::kNames[i]);
      if (index >= 0) {
        const EntityModel::Joint& joint = instance.model->joints[static_cast<std::size_t>(index)];
        *angles[i] = std::clamp(*angles[i], joint.lower, joint.upper);
      }
    }
  }

 private:
  double noise_ = 0.0;  // rad
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::HandbotArmsActuator)
