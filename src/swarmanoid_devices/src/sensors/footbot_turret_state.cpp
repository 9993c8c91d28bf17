// The turret's encoder and the torque of its motor, as written by the engine that moves the robot.
#include "mechanisms.hpp"
#include "parameters.hpp"
#include "swarmanoid_interface/devices/footbot_turret.hpp"
#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid::devices {
namespace {

struct TurretStateInstance : BasicSensorInstance<FootbotTurretState> {
  int joint = -1;  // index of the joint in the robot's model
};

class FootbotTurretStateSensor final : public SensorOf<FootbotTurretState, TurretStateInstance> {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = FootbotTurretState::kType;
    description.implementation = "default";
    description.is_default = true;
    description.mechanisms = {joint("turret")};
    description.summary = "Where the turret stands, how fast it turns, and the torque of its motor.";
    description.parameters = {
        angle("noise", "0", {0.0, 10.0}, "Standard deviation added to the angle."),
        number("noise_torque", "N m", "0", {0.0, 10.0}, "Standard deviation added to the torque.")};
    return description;
  }

  void configure(const Configuration& parameters) override {
    addErrorAlias("gaussian", "angle", "deviation", parameters.angle("noise", 0.0));
    addErrorAlias("gaussian", "torque", "deviation", parameters.number("noise_torque", 0.0));
  }

  void sense(const Space& space, std::size_t first, std::size_t last) override {
    for (std::size_t k = first; k < last; ++k) {
      TurretStateInstance& instance = instances_[k];
      if (instance.joint < 0) {
        continue;
      }
      const JointState& state = space.joints[instance.row][instance.joint];
      *instance.readings = {state.angle, state.speed, state.effort};
    }
  }

 protected:
  void prepareInstance(const Space& space, TurretStateInstance& instance) override {
    instance.joint = space.entities.model[instance.row]->findJoint("turret");
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::FootbotTurretStateSensor)
