/// The implementation `slipping` of any two-wheel drive, and the macro that registers a drive with it.
#pragma once

#include <algorithm>
#include <string>

#include "common/parameters.hpp"
#include "wheel_drive.hpp"

namespace swarmanoid::devices {

/// Lower bound of the ratio of ground speed to wheel speed: a slipping wheel does not drive backwards.
constexpr double kLeastGrip = 0.01;

/// A two-wheel drive with slip: the implementation `slipping`. By the definition of slip, i = 1 - v / (r omega) (J. Y.
/// Wong, Theory of Ground Vehicles, Wiley), the robot advances as if a wheel turned 1 - i times as fast as it does. The
/// factor is drawn anew in each tick, so that the error of a wheel's speed grows with the speed (Thrun, Burgard and
/// Fox, Probabilistic Robotics, MIT Press 2005, section 5.3). Encoders measure the turns of the wheel.
///
/// Phases  `actuate` commands the ground speed under the wheels to the engine. `afterMove` converts the turns over
///         ground that the engine reports (Space::wheel_turns) to wheel turns, limited to those of motors at full
///         speed: an engine with forces does not reach the speed of this tick at once.
template <class Drive>
class SlippingDrive final : public Drive {
 public:
  static PluginDescription describe() {
    PluginDescription description = Drive::describe();
    description.implementation = "slipping";
    description.is_default = false;
    description.implementation_aliases.clear();
    description.summary += " On the ground they slip.";
    const Range any{0.0, 1.0 - kLeastGrip};
    description.parameters = {number("slip_left", "", "0.05", any,
                                     "Slip of the left wheel: share of its rotation that does not move the robot."),
                              number("slip_right", "", "0.05", any, "Slip of the right wheel."),
                              number("slip_noise", "", "0.02", {0.0, 1.0},
                                     "Standard deviation of each of these shares, drawn anew in each tick.")};
    return description;
  }

  void configure(const Configuration& parameters) override {
    slip_ = {parameters.number("slip_left"), parameters.number("slip_right")};
    noise_ = parameters.number("slip_noise");
  }

  void afterMove(const Space& space, const AfterMoveAccess& access) override {
    for (Instance& instance : this->instances_) {
      WheelTurns& turns = access.wheel_turns[instance.row];
      const WheelTurns& before = instance.turns_before;
      const WheelGrip& grip = space.wheels[instance.row].grip;
      const double most = instance.wheels->max_speed * toSeconds(space.clocktick);
      turns = {before.left + std::clamp((turns.left - before.left) / grip.left, -most, most),
               before.right + std::clamp((turns.right - before.right) / grip.right, -most, most)};
      instance.turns_before = turns;
    }
  }

 protected:
  using Instance = typename Drive::Instance;

  void apply(const Space& space, const ActuateAccess& access, Instance& instance) override {
    Drive::apply(space, access, instance);
    instance.random.startTick(space.tick);
    instance.turns_before = space.wheel_turns[instance.row];
    WheelsCommand& wheels = access.wheels[instance.row];
    wheels.grip.left = drawGrip(instance, slip_.left);
    wheels.grip.right = drawGrip(instance, slip_.right);
    wheels.left *= wheels.grip.left;
    wheels.right *= wheels.grip.right;
  }

 private:
  /// @return ratio of ground speed to wheel speed
  double drawGrip(Instance& instance, double slip) const {
    const double part = noise_ > 0.0 ? instance.random.gaussian(1.0 - slip, noise_) : 1.0 - slip;
    return std::max(part, kLeastGrip);
  }

  struct {
    double left = 0.0;
    double right = 0.0;
  } slip_;
  double noise_ = 0.0;
};

}  // namespace swarmanoid::devices

/// At the end of a drive's source: registers the drive with and without slip.
#define REGISTER_WHEEL_DRIVE(Class) \
  REGISTER_ACTUATOR(Class)          \
  REGISTER_ACTUATOR(::swarmanoid::devices::SlippingDrive<Class>)
