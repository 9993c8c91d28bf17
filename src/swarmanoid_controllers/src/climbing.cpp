// A handbot that climbs along a wall by its rope, grips an object that sticks out at the top with its left hand and
// carries it down. It starts when its distance sensors detect a wall ahead and its carriers have released it, stops
// climbing where the sensors no longer detect the wall, feels for the object with its hand, lower at each try, and has
// arrived at the ground when the rope is slack.
#include <algorithm>
#include <cmath>

#include "carrying_words.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"
#include "swarmanoid_interface/devices/handbot_distance.hpp"
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
    distance_ = &robot.sensor<HandbotDistance>();
    if (robot.hasActuator(Wifi::kType)) {  // a carried handbot reports to its carriers
      wifi_ = &robot.actuator<Wifi>();
      received_ = &robot.sensor<WifiReceived>();
    }
    parameters.refuseUnread({});
    reset();
  }

  void reset() override {
    tries_ = 0;
    is_at_wall_ = false;
    *arms_ = HandbotArms{};
    *hands_ = HandbotHands{};
    *rope_ = HandbotRope{};
    if (wifi_ != nullptr) {
      wifi_->fallSilent();
    }
    enter(State::kWaiting);
  }

  void step(Time, Duration dt) override {
    dt_ = toSeconds(dt);
    since_ += dt_;
    switch (state_) {
      case State::kWaiting:
        return wait();
      case State::kShooting:
        return shoot();
      case State::kClimbing:
        return climb();
      case State::kAdjusting:
        return adjust();
      case State::kReaching:
        return reach();
      case State::kTaking:
        return take();
      case State::kDescending:
        return descend();
      case State::kDone:
        return;
    }
  }

  void archive(StateArchive& state) override { state(state_, since_, length_, tries_, is_at_wall_); }

 private:
  enum class State { kWaiting, kShooting, kClimbing, kAdjusting, kReaching, kTaking, kDescending, kDone };

  static constexpr double kUp = -1.5;        // rad, of the shoulders
  static constexpr double kDown = 0.65;      // rad
  static constexpr double kWinding = 0.1;    // m/s
  static constexpr double kSwift = 1.0;      // rad/s, of the shoulders
  static constexpr double kCarefully = 0.5;  // rad/s, with an object
  static constexpr double kFeeling = 0.4;    // rad/s
  static constexpr double kBent = 1.0;       // rad, of the elbows
  static constexpr double kSettling = 1.0;   // s

  void enter(State state) {
    static constexpr const char* kNames[] = {"waiting",  "shooting", "climbing",   "adjusting",
                                             "reaching", "taking",   "descending", "done"};
    state_ = state;
    since_ = 0.0;
    robot_->debug("state", kNames[static_cast<int>(state)]);
  }

  /// Waits until it stands at a wall and its carriers have been silent for a while.
  void wait() {
    constexpr double kNear = 0.09;  // m
    constexpr double kAway = 0.11;  // m: larger than kNear because the readings are noisy
    constexpr double kQuiet = 1.0;  // s
    is_at_wall_ = distance_->value(0) < (is_at_wall_ ? kAway : kNear);
    if (wifi_ != nullptr && is_at_wall_) {
      say(*wifi_, CarryingWord::kArrived);
    }
    const bool is_held = received_ != nullptr &&
                         (isHeard(*received_, CarryingWord::kHolding) || isHeard(*received_, CarryingWord::kGripping));
    if (!is_at_wall_ || is_held) {
      since_ = 0.0;
    } else if (since_ > kQuiet) {
      if (wifi_ != nullptr) {
        wifi_->fallSilent();
      }
      enter(State::kShooting);
    }
  }

  void shoot() {
    rope_->shot = true;
    const bool are_down = moveArms(kDown, kSwift);
    if (rope_state_->attached && are_down) {
      enter(State::kClimbing);
    }
  }

  void climb() {
    constexpr double kFar = 0.2;        // m: there is no wall
    constexpr double kBesideTop = 0.3;  // s
    constexpr double kShortest = 0.3;   // m, of the rope: the robot is at the ceiling
    constexpr double kBelow = 0.047;    // m, from there to the first height at which the hand feels for the object
    constexpr double kSmoothly = 0.02;  // m/s2: a higher acceleration makes the robot turn about the rope at lift-off
    rope_->winding_speed = std::min(kWinding, rope_->winding_speed + kSmoothly * dt_);
    const bool sees_wall = !(distance_->value(0) > kFar);
    if (sees_wall) {
      since_ = 0.0;
    } else if (since_ > kBesideTop) {
      length_ = rope_state_->length + kBelow;
      enter(State::kAdjusting);
    }
    if (rope_state_->length < kShortest) {
      enter(State::kDescending);
    }
  }

  /// Moves to the height where the hand will feel for the object, with the arms below it. The elbows are bent while the
  /// arms move down, so that the hand does not touch the object from above.
  void adjust() {
    const bool are_down = moveArms(kDown, kSwift);
    const bool are_straight = bendElbows(are_down ? 0.0 : kBent);
    const bool is_there = wind(length_);
    if (are_down && are_straight && is_there && since_ > kSettling) {
      enter(State::kReaching);
    }
  }

  /// Raises the hand until it holds the object. After a miss it tries lower, and descends after the last try.
  void reach() {
    constexpr double kReached = -0.5;  // rad: above every object within reach
    constexpr double kStep = 0.015;    // m
    wind(length_);
    hands_->left = true;
    if (isHolding()) {
      return enter(State::kTaking);
    }
    if (moveArms(kReached, kFeeling)) {
      length_ += kStep;
      tryAgain();
    }
  }

  /// Raises the object. If the grip is lost, it feels for the object again.
  void take() {
    if (!isHolding()) {
      return tryAgain();
    }
    wind(length_ - 0.1);
    if (moveArms(kUp, kCarefully)) {
      enter(State::kDescending);
    }
  }

  void tryAgain() {
    constexpr int kMostTries = 5;
    hands_->left = false;
    ++tries_;
    enter(tries_ < kMostTries ? State::kAdjusting : State::kDescending);
  }

  void descend() {
    constexpr double kSlack = 1.0;  // N
    rope_->winding_speed = -kWinding;
    if (since_ > kSettling && rope_state_->tension < kSlack) {
      rope_->winding_speed = 0.0;
      rope_->shot = false;
      enter(State::kDone);
    }
  }

  bool isHolding() const { return hands_state_->left.holding; }

  /// @param angle outwards [rad] @return whether both elbows are commanded to it
  bool bendElbows(double angle) {
    const double most = kSwift * dt_;
    arms_->left.elbow += std::clamp(angle - arms_->left.elbow, -most, most);
    arms_->right.elbow = -arms_->left.elbow;
    return arms_->left.elbow == angle;
  }

  /// Moves both shoulders with a limited speed. @return whether the left one has arrived
  bool moveArms(double angle, double speed) {
    constexpr double kClose = 0.05;  // rad
    const double most = speed * dt_;
    const double next = arms_->left.shoulder + std::clamp(angle - arms_->left.shoulder, -most, most);
    arms_->left.shoulder = next;
    arms_->right.shoulder = next;
    return next == angle && std::abs(arms_state_->joints[0].angle - angle) < kClose;
  }

  /// @return whether the rope has that length
  bool wind(double length) {
    constexpr double kClose = 5e-3;  // m
    const double missing = rope_state_->length - length;
    rope_->winding_speed = std::copysign(std::min(kWinding, std::abs(missing) / dt_), missing);
    return std::abs(missing) < kClose;
  }

  Robot* robot_ = nullptr;
  HandbotArms* arms_ = nullptr;
  HandbotHands* hands_ = nullptr;
  HandbotRope* rope_ = nullptr;
  Wifi* wifi_ = nullptr;  // null: the robot is not carried
  const HandbotArmsState* arms_state_ = nullptr;
  const HandbotHandsState* hands_state_ = nullptr;
  const HandbotRopeState* rope_state_ = nullptr;
  const HandbotDistance* distance_ = nullptr;
  const WifiReceived* received_ = nullptr;
  State state_ = State::kWaiting;
  double dt_ = 0.1;      // s, of the tick
  double since_ = 0.0;   // s, in this state, or since its condition was last violated
  double length_ = 0.0;  // m, of the rope, while the hand feels for the object
  int tries_ = 0;
  bool is_at_wall_ = false;
};

}  // namespace swarmanoid

REGISTER_CONTROLLER(swarmanoid::Climbing, "climbing")
