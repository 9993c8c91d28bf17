// For tests of the boundary between the suite and users' code: a controller that misbehaves as its parameters say.
//
//     phase   init, step, reset, destroy, destructor, or several in one text, which are tried in turn; "never"
//     action  one of actions.cpp
//     tick    the controller's own count at which `step` misbehaves (3)
//     only    name of the only robot that misbehaves (all misbehave)
//
// For phases before the parameters are available, the environment names phase and action: MISBEHAVING="PHASE ACTION",
// with the phases `load` (the library's static constructor), `factory` (the controller's constructor) and `unload` (the
// static destructor).
#include <cstdlib>
#include <sstream>
#include <string>

#include "actions.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"

namespace swarmanoid::test {
namespace {

void actIfToldTo(const std::string& phase) {
  const char* told = std::getenv("MISBEHAVING");
  std::istringstream words(told == nullptr ? "" : told);
  std::string asked;
  std::string action;
  if (words >> asked >> action && asked == phase) {
    perform(action);
  }
}

struct WhileLoaded {
  WhileLoaded() { actIfToldTo("load"); }
  ~WhileLoaded() noexcept(false) { actIfToldTo("unload"); }
};

const WhileLoaded kWhileLoaded;

class Misbehaving final : public Controller {
 public:
  Misbehaving() { actIfToldTo("factory"); }
  ~Misbehaving() override { tryIn("destructor"); }

  void init(Robot& robot, const Configuration& parameters) override {
    wheels_ = robot.hasActuator(FootbotWheels::kType) ? &robot.actuator<FootbotWheels>() : nullptr;
    phase_ = parameters.text("phase", "never");
    action_ = parameters.text("action", "nothing");
    tick_ = parameters.integer("tick", std::int64_t{3});
    const std::string only = parameters.text("only", "");
    parameters.refuseUnread({"phase", "action", "tick", "only"});
    is_meant_ = only.empty() || only == robot.name();
    tryIn("init");
  }

  void step(Time, Duration) override {
    if (wheels_ != nullptr) {
      wheels_->setAngularVelocity(1.0, 1.0);
    }
    if (steps_++ == tick_) {
      tryIn("step");
    }
  }

  void reset() override {
    steps_ = 0;
    tryIn("reset");
  }

  void destroy() override { tryIn("destroy"); }

 private:
  void tryIn(const std::string& phase) const {
    std::istringstream phases(phase_);
    for (std::string word; is_meant_ && phases >> word;) {
      if (word == phase) {
        perform(action_);
      }
    }
  }

  FootbotWheels* wheels_ = nullptr;
  std::string phase_;
  std::string action_;
  bool is_meant_ = false;
  std::int64_t tick_ = 0;
  std::int64_t steps_ = 0;
};

}  // namespace
}  // namespace swarmanoid::test

REGISTER_CONTROLLER(swarmanoid::test::Misbehaving, "misbehaving")
