// The joints of any robot.
#include "swarmanoid_interface/devices/joints.hpp"

#include "common/joints.hpp"

namespace swarmanoid::devices {
namespace {

class JointsActuator final : public JointActuator<JointsActuator, Joints, Joints::kMost> {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = Joints::kType;
    description.implementation = "default";
    description.is_default = true;
    description.mechanisms = {allJoints()};
    description.summary = "Turns each joint: to an angle, at a speed, or as it is pulled; within its stops.";
    return description;
  }

  static std::array<int, Joints::kMost> indicesIn(const EntityModel& model) {
    return allOf<Joints::kMost>(Joints::kType, model, model.joints.size(), "joints");
  }
  static JointTarget targetOf(Joints& joints, std::size_t which) { return targetOfMotor(joints.joints[which]); }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::JointsActuator)
