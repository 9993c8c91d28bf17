// Two or more footbots carry a robot between them: each grips it at its side by the turret. They drive when none of
// them reports a missing grip by WiFi, and release the robot when it reports that it has arrived.
#include <cmath>

#include "carrying_words.hpp"
#include "differential_drive.hpp"
#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/footbot_turret.hpp"
#include "swarmanoid_interface/devices/leds.hpp"

namespace swarmanoid {

class Carrying final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    robot_ = &robot;
    wheels_ = &robot.actuator<FootbotWheels>();
    gripper_ = &robot.actuator<FootbotGripper>();
    turret_ = &robot.actuator<FootbotTurret>();
    leds_ = &robot.actuator<FootbotLeds>();
    wifi_ = &robot.actuator<Wifi>();
    gripper_state_ = &robot.sensor<FootbotGripperState>();
    turret_state_ = &robot.sensor<FootbotTurretState>();
    received_ = &robot.sensor<WifiReceived>();
    side_ = parameters.angle("side", 0.0);
    speed_ = parameters.number("speed", 0.1, {0.0, 0.3});
    parameters.refuseUnread({"side", "speed"});
    reset();
  }

  void reset() override {
    *wheels_ = FootbotWheels{};
    *gripper_ = FootbotGripper{};
    *turret_ = FootbotTurret{};
    wifi_->fallSilent();
    enter(State::kGripping, colors::kYellow);
  }

  void step(Time, Duration dt) override {
    turret_->holdAngle(side_);
    since_ += toSeconds(dt);
    if ((state_ == State::kWaiting || state_ == State::kCarrying) && !gripper_state_->gripping) {
      gripper_->open();  // a broken grip engages again only after the gripper was opened
      return enter(State::kGripping, colors::kYellow);
    }
    switch (state_) {
      case State::kGripping:
        return grip();
      case State::kWaiting:
        return wait();
      case State::kCarrying:
        return carry();
      case State::kReleasing:
        return release();
      case State::kResting:
        return;
    }
  }

  void archive(StateArchive& state) override { state(state_, since_); }

 private:
  enum class State { kGripping, kWaiting, kCarrying, kReleasing, kResting };

  void enter(State state, Color color) {
    static constexpr const char* kNames[] = {"gripping", "waiting", "carrying", "releasing", "resting"};
    state_ = state;
    since_ = 0.0;
    wheels_->drive(0.0, 0.0);
    leds_->setAll(color);
    robot_->debug("state", kNames[static_cast<int>(state)]);
  }

  void grip() {
    constexpr double kClose = 0.05;  // rad
    say(*wifi_, CarryingWord::kGripping);
    gripper_->closed = std::abs(wrapAngle(turret_state_->angle - side_)) < kClose;
    if (gripper_state_->gripping) {
      enter(State::kWaiting, colors::kYellow);
    }
  }

  /// Waits until no message of a robot without a grip has arrived for a while.
  void wait() {
    constexpr double kQuiet = 0.3;  // s
    say(*wifi_, CarryingWord::kHolding);
    if (isHeard(*received_, CarryingWord::kGripping)) {
      since_ = 0.0;
    } else if (since_ > kQuiet) {
      enter(State::kCarrying, colors::kGreen);
    }
  }

  void carry() {
    say(*wifi_, CarryingWord::kHolding);
    wheels_->drive(speed_, 0.0);
    if (isHeard(*received_, CarryingWord::kArrived)) {
      enter(State::kReleasing, colors::kBlue);
    } else if (isHeard(*received_, CarryingWord::kGripping)) {
      enter(State::kWaiting, colors::kYellow);
    }
  }

  void release() {
    constexpr double kSettling = 0.3;  // s, until the carried robot has come to rest
    gripper_->closed = since_ < kSettling;
    if (!gripper_->closed && !gripper_state_->gripping) {
      wifi_->fallSilent();
      enter(State::kResting, colors::kBlue);
    }
  }

  Robot* robot_ = nullptr;
  FootbotWheels* wheels_ = nullptr;
  FootbotGripper* gripper_ = nullptr;
  FootbotTurret* turret_ = nullptr;
  FootbotLeds* leds_ = nullptr;
  Wifi* wifi_ = nullptr;
  const FootbotGripperState* gripper_state_ = nullptr;
  const FootbotTurretState* turret_state_ = nullptr;
  const WifiReceived* received_ = nullptr;
  State state_ = State::kGripping;
  double since_ = 0.0;  // s, in this state
  double side_ = 0.0;   // rad, direction of the carried robot, counter-clockwise from ahead
  double speed_ = 0.0;  // m/s
};

}  // namespace swarmanoid

REGISTER_CONTROLLER(swarmanoid::Carrying, "carrying")
