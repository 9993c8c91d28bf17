// A controller for tests of hosts: it moves all its actuators, a little faster each time, and misbehaves on demand.
#include <chrono>
#include <stdexcept>
#include <thread>

#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/eyebot_laser.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/footbot_turret.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"
#include "swarmanoid_interface/devices/handbot_hands.hpp"
#include "swarmanoid_interface/devices/handbot_rope.hpp"

namespace swarmanoid::test {

class Misbehaving final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    robot_ = &robot;
    throw_at_ = parameters.number("throw_at", kInfinity);
    sleep_at_ = parameters.number("sleep_at", kInfinity);
    sleep_ = parameters.number("sleep", 0.5, {0.0, 10.0});
    parameters.refuseUnread({"throw_at", "sleep_at", "sleep"});
  }

  void step(Time time, Duration) override {
    const double now = toSeconds(time - kEpoch);
    command<FootbotWheels>([=](FootbotWheels& wheels) { wheels.setAngularVelocity(1.0 + now, 1.0 + now); });
    command<FootbotTurret>([](FootbotTurret& turret) { turret.turnAt(1.0); });
    command<FootbotGripper>([](FootbotGripper& gripper) { gripper.close(); });
    command<EyebotVelocity>([=](EyebotVelocity& velocity) { velocity.linear.x() = 0.1 + 0.01 * now; });
    command<EyebotLaser>([](EyebotLaser& laser) { laser.on = true; });
    command<HandbotArms>([](HandbotArms& arms) { arms.left.shoulder = -1.0; });
    command<HandbotHands>([](HandbotHands& hands) { hands.left = true; });
    command<HandbotRope>([=](HandbotRope& rope) { rope = {true, 0.1 + 0.01 * now}; });
    robot_->debug("state", "misbehaving");
    if (now >= throw_at_) {
      throw std::runtime_error("told to");
    }
    if (now >= sleep_at_) {
      sleep_at_ = kInfinity;
      std::this_thread::sleep_for(std::chrono::duration<double>(sleep_));
    }
  }

 private:
  template <class Device, class Write>
  void command(Write write) {
    if (robot_->hasActuator(Device::kType)) {
      write(robot_->actuator<Device>());
    }
  }

  Robot* robot_ = nullptr;
  double throw_at_ = kInfinity;  // [s]
  double sleep_at_ = kInfinity;  // [s]
  double sleep_ = 0.5;           // [s]
};

}  // namespace swarmanoid::test

REGISTER_CONTROLLER(swarmanoid::test::Misbehaving, "misbehaving")
