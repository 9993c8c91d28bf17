// Encoders and torque sensors of the joints of any robot.
#include "common/joints.hpp"
#include "common/span_readings.hpp"
#include "swarmanoid_interface/devices/joints.hpp"

namespace swarmanoid::devices {
namespace {

using RoomyJointStates = SpanReadings<BasicSensorInstance<JointStates>, JointStates::Joint>;

class JointStatesSensor final
    : public JointSensor<JointStatesSensor, JointStates, JointStates::kMost, RoomyJointStates> {
  using Base = JointSensor<JointStatesSensor, JointStates, JointStates::kMost, RoomyJointStates>;

 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = JointStates::kType;
    description.implementation = "default";
    description.is_default = true;
    description.summary = "Angle, speed and effort of each joint.";
    return description;
  }

  static std::array<int, JointStates::kMost> indicesIn(const EntityModel& model) {
    return allOf<JointStates::kMost>(JointStates::kType, model, model.joints.size(), "joints");
  }
  static void read(Instance& instance, std::size_t which, const JointState& state) {
    instance.buffer[which] = {state.angle, state.speed, state.effort};
  }

 protected:
  std::size_t mostElements() const override { return JointStates::kMost; }

  void prepareInstance(const Space& space, Instance& instance) override {
    Base::prepareInstance(space, instance);
    instance.readings->joints = instance.makeRoom(instance.model->joints.size());
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::JointStatesSensor)
