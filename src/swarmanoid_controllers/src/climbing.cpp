// A handbot that climbs to a shelf by its rope, takes the object there with its left hand and brings it down.
#include <algorithm>
#include <cmath>

#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"
#include "swarmanoid_interface/devices/handbot_hands.hpp"
#include "swarmanoid_interface/devices/handbot_rope.hpp"

namespace swarmanoid {

class Climbing final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    robot_ = &robot;
    arms_ = &robot.actuator<HandbotArms>();
    hands_ = &robot.actuator<HandbotHands>();
    rope_ = &robot.actuator<HandbotRope>();
    arms_state_ = &robot.sensor<HandbotArmsState>();
    hands_state_ = &robot.sensor<HandbotHandsState>();
    rope_state_ = &robot.sensor<HandbotRopeState>();
    start_ = parameters.number("start", 1.0, {0.0, 1e6});
    rope_length_ = parameters.number("rope_length", 1.5, {0.1, 3.0});
    parameters.refuseUnread({"start", "rope_length"});
  }

  void reset() override { enter(State::kWaiting); }

  void step(Time time, Duration dt) override {
    dt_ = toSeconds(dt);
    const double now = toSeconds(time - kEpoch);
    switch (state_) {
      case State::kWaiting:
        if (now >= start_) {
          enter(State::kShooting);
        }
        break;
      case State::kShooting:
        raiseArms();
        rope_->shot = true;
        if (rope_state_->attached && areArmsUp()) {
          enter(State::kClimbing);
        }
        break;
      case State::kClimbing:
        if (wind(rope_length_, 0.1)) {
          enter(State::kReaching);
        }
        break;
      case State::kReaching:
        hands_->left = true;
        lowerArms(kReachSpeed * dt_);
        if (hands_state_->left.holding) {
          enter(State::kTaking);
        }
        break;
      case State::kTaking:
        raiseArms();
        wind(rope_length_ - 0.1, 0.1);
        if (areArmsUp()) {
          enter(State::kDescending);
        }
        break;
      case State::kDescending:
        rope_->winding_speed = -0.1;
        if (rope_state_->tension < kSlack) {
          enter(State::kDone);
        }
        break;
      case State::kDone:
        rope_->winding_speed = 0.0;
        rope_->shot = false;
        break;
    }
  }

 private:
  enum class State { kWaiting, kShooting, kClimbing, kReaching, kTaking, kDescending, kDone };

  static constexpr double kUp = -1.5;         // rad, of the shoulders
  static constexpr double kReachSpeed = 0.5;  // rad/s
  static constexpr double kSlack = 1.0;       // N

  void enter(State state) {
    static constexpr const char* kNames[] = {"waiting", "shooting",   "climbing", "reaching",
                                             "taking",  "descending", "done"};
    state_ = state;
    robot_->debug("state", kNames[static_cast<int>(state)]);
  }

  void raiseArms() {
    arms_->left.shoulder = kUp;
    arms_->right.shoulder = kUp;
  }
  bool areArmsUp() const {
    constexpr double kClose = 0.05;  // rad
    constexpr std::size_t kLeft = 0;
    constexpr std::size_t kRight = 3;
    return std::abs(arms_state_->joints[kLeft].angle - kUp) < kClose &&
           std::abs(arms_state_->joints[kRight].angle - kUp) < kClose;
  }
  void lowerArms(double turn) { arms_->left.shoulder = std::min(arms_->left.shoulder + turn, 0.3); }

  /// @return whether the rope has that length
  bool wind(double length, double speed) {
    constexpr double kClose = 1e-3;  // m
    const double missing = rope_state_->length - length;
    rope_->winding_speed = std::copysign(std::min(speed, std::abs(missing) / dt_), missing);
    return std::abs(missing) < kClose;
  }

  Robot* robot_ = nullptr;
  HandbotArms* arms_ = nullptr;
  HandbotHands* hands_ = nullptr;
  HandbotRope* rope_ = nullptr;
  const HandbotArmsState* arms_state_ = nullptr;
  const HandbotHandsState* hands_state_ = nullptr;
  const HandbotRopeState* rope_state_ = nullptr;
  State state_ = State::kWaiting;
  double dt_ = 0.1;           // s, of the tick
  double start_ = 0.0;        // s after the run began
  double rope_length_ = 0.0;  // m, at which the hands are at the height of the object
};

}  // namespace swarmanoid

REGISTER_CONTROLLER(swarmanoid::Climbing, "climbing")
