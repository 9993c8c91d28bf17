// Turret: the command is limited to the motor's range. The engine that moves the robot turns the turret.
#include "swarmanoid_interface/devices/footbot_turret.hpp"

#include "common/joints.hpp"
#include "common/parameters.hpp"

namespace swarmanoid::devices {
namespace {

class FootbotTurretActuator final : public JointActuator<FootbotTurretActuator, FootbotTurret> {
  using Base = JointActuator<FootbotTurretActuator, FootbotTurret>;

 public:
  static constexpr auto kJoints = kTurretJoint;

  static PluginDescription describe() {
    PluginDescription description;
    description.label = FootbotTurret::kType;
    description.implementation = "default";
    description.is_default = true;
    description.mechanisms = joints(kJoints);
    description.summary = "Turns the gripper against the chassis: to an angle, at a speed, or as it is pulled.";
    description.parameters = {
        number("noise", "", "0", {0.0, 1.0}, "Standard deviation of the factor that a speed is multiplied with."),
        angle("noise_angle", "0", {0.0, 90.0}, "Standard deviation added to an angle.")};
    return description;
  }

  static JointTarget targetOf(FootbotTurret& turret, std::size_t /*which*/) { return targetOfMotor(turret); }

  void configure(const Configuration& parameters) override {
    noise_ = parameters.number("noise", 0.0);
    noise_angle_ = parameters.angle("noise_angle", 0.0);
  }

 protected:
  void limit(const Space& space, Instance& instance) override {
    FootbotTurret& turret = *instance.actuation;
    instance.random.startTick(space.tick);
    if (turret.mode == FootbotTurret::Mode::kAngle && noise_angle_ > 0.0) {
      turret.angle += instance.random.gaussian(0.0, noise_angle_);
    } else if (turret.mode == FootbotTurret::Mode::kSpeed && noise_ > 0.0) {
      turret.speed *= instance.random.gaussian(1.0, noise_);
    }
    Base::limit(space, instance);
  }

 private:
  double noise_ = 0.0;
  double noise_angle_ = 0.0;  // rad
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::FootbotTurretActuator)
