// Turret: the command is limited by its motor. The engine that moves the robot turns the turret.
#include "swarmanoid_interface/devices/footbot_turret.hpp"

#include <algorithm>

#include "mechanisms.hpp"
#include "parameters.hpp"
#include "swarmanoid_space/actuator.hpp"

namespace swarmanoid::devices {
namespace {

struct TurretInstance : BasicActuatorInstance<FootbotTurret> {
  int joint = -1;          // index of the joint in the model
  double max_speed = 0.0;  // rad/s
};

class FootbotTurretActuator final : public ActuatorOf<FootbotTurret, TurretInstance> {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = FootbotTurret::kType;
    description.implementation = "default";
    description.is_default = true;
    description.mechanisms = {joint("turret")};
    description.summary = "Turns the gripper against the chassis: to an angle, at a speed, or as it is pulled.";
    description.parameters = {
        number("noise", "", "0", {0.0, 1.0}, "Standard deviation of the factor that a speed is multiplied with."),
        angle("noise_angle", "0", {0.0, 90.0}, "Standard deviation added to an angle.")};
    return description;
  }

  void configure(const Configuration& parameters) override {
    noise_ = parameters.number("noise", 0.0);
    noise_angle_ = parameters.angle("noise_angle", 0.0);
  }

 protected:
  void prepareInstance(const Space& space, TurretInstance& instance) override {
    const EntityModel& model = *space.entities.model[instance.row];
    instance.joint = model.findJoint("turret");
    // engines refuse a robot without a turret, of whatever type; a robot in no engine is asked by none
    instance.max_speed = instance.joint < 0 ? 0.0 : model.joints[static_cast<std::size_t>(instance.joint)].max_speed;
  }

  void limit(const Space& space, TurretInstance& instance) override {
    FootbotTurret& turret = *instance.actuation;
    instance.random.startTick(space.tick);
    if (turret.mode == FootbotTurret::Mode::kAngle) {
      if (noise_angle_ > 0.0) {
        turret.angle += instance.random.gaussian(0.0, noise_angle_);
      }
    } else if (turret.mode == FootbotTurret::Mode::kSpeed) {
      if (noise_ > 0.0) {
        turret.speed *= instance.random.gaussian(1.0, noise_);
      }
      turret.speed = std::clamp(turret.speed, -instance.max_speed, instance.max_speed);
    }
  }

  void apply(Space& space, TurretInstance& instance) override {
    using Mode = JointCommand::Mode;
    if (instance.joint >= 0) {
      const FootbotTurret& turret = *instance.actuation;
      space.joint_commands[instance.row][static_cast<std::size_t>(instance.joint)] =
          turret.mode == FootbotTurret::Mode::kAngle   ? JointCommand{Mode::kAngle, turret.angle}
          : turret.mode == FootbotTurret::Mode::kSpeed ? JointCommand{Mode::kSpeed, turret.speed}
                                                       : JointCommand{Mode::kPassive, 0.0};
    }
  }

 private:
  double noise_ = 0.0;
  double noise_angle_ = 0.0;  // rad
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::FootbotTurretActuator)
