// A footbot that is charged beside perches: it wanders; when little is left in its battery it looks for a perch that
// shows that it is free, stands beside it until the battery is full, and wanders again. While it is charged it shines
// blue, and whoever sees that leaves the perch alone. A robot that ran empty beside a perch starts anew there, and
// stays until it is full.
#include <algorithm>
#include <string>

#include "blob_search.hpp"
#include "differential_drive.hpp"
#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/battery.hpp"
#include "swarmanoid_interface/devices/leds.hpp"

namespace swarmanoid {

class FootbotCharging final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    robot_ = &robot;
    wheels_ = &robot.actuator<FootbotWheels>();
    leds_ = &robot.actuator<FootbotLeds>();
    proximity_ = &robot.sensor<FootbotProximity>();
    camera_ = &robot.sensor<FootbotCamera>();
    battery_ = &robot.sensor<Battery>();
    speed_ = parameters.number("speed", 0.15, {0.01, 0.3});
    little_ = parameters.number("little", 0.6, {0.0, 1.0});
    plenty_ = parameters.number("plenty", 0.98, {0.0, 1.0});
    free_color_ = parameters.color("free_color", colors::kGreen);
    taken_color_ = parameters.color("taken_color", colors::kYellow);
    parameters.refuseUnread({"speed", "little", "plenty", "free_color", "taken_color"});
    reset();
  }

  void reset() override {
    memory_ = Memory{};
    *wheels_ = FootbotWheels{};
    enter(State::kWander);
  }

  void step(Time, Duration dt) override {
    dt_ = toSeconds(dt);
    if (!memory_.has_looked) {
      memory_.has_looked = true;
      chooseLimit();
      const std::optional<Sighting> perch = nearestUnattended(taken_color_);
      if (perch && perch->distance() < kTaken) {
        enter(State::kCharge);
      }
    }
    switch (memory_.state) {
      case State::kWander:
        return wander();
      case State::kSeek:
        return seek();
      case State::kCharge:
        return charge();
    }
  }

 private:
  enum class State { kWander, kSeek, kCharge };

  static constexpr Color kCharging = colors::kBlue;  // of the LEDs while it stands beside a perch
  static constexpr double kBeside = 0.26;  // m from the perch: it is within reach, and its post not yet an obstacle
  static constexpr double kTaken = 0.36;   // m: farther than the reach, by what the camera may err

  static const char* nameOf(State state) {
    switch (state) {
      case State::kWander:
        return "Wander";
      case State::kSeek:
        return "Seek Perch";
      case State::kCharge:
        return "Charge";
    }
    return "";
  }

  void enter(State state) {
    memory_.state = state;
    memory_.turn_rate = 0.0;
    memory_.avoiding_turn = 0.0;
    memory_.escape_left = 0.0;
    memory_.time_unserved = 0.0;
    leds_->setAll(state == State::kCharge ? kCharging : colors::kBlack);
    robot_->debug("state", nameOf(state));
  }

  /// Robots that have the same left would all come at once.
  void chooseLimit() { memory_.limit = robot_->random().uniform(0.7, 1.0) * little_; }

  void wander() {
    if (battery_->fraction() < memory_.limit) {
      return enter(State::kSeek);
    }
    if (isAvoiding()) {
      return;
    }
    memory_.turn_rate = wanderingTurnRate(robot_->random(), memory_.turn_rate, dt_);
    wheels_->drive(speed_, memory_.turn_rate);
  }

  void seek() {
    const std::optional<Sighting> perch = nearestUnattended(free_color_);
    const std::optional<Sighting> taken = nearestUnattended(taken_color_);
    const bool has_arrived = perch && perch->distance() < kBeside;
    if (has_arrived || (taken && taken->distance() < kTaken)) {  // or the perch has taken it on its way
      return enter(State::kCharge);
    }
    if (!perch) {
      return waitForPerch();
    }
    if (!isAvoiding()) {
      steer(*wheels_, perch->bearing(), speed_);
    }
  }

  /// Whoever stands still needs little, and whoever keeps away is not in the way of others.
  void waitForPerch() {
    constexpr double kRoom = 0.5;  // m
    const std::optional<Sighting> perch = nearestBlob(*camera_, taken_color_);
    if (!perch || perch->distance() > kRoom) {
      return wheels_->drive(0.0, 0.0);
    }
    if (!isAvoiding()) {
      steer(*wheels_, wrapAngle(perch->bearing() + M_PI), speed_);
    }
  }

  /// A perch that charges shows that it is taken; else it has nothing left, or charges nobody.
  void charge() {
    constexpr double kUnserved = 2.0;  // s
    wheels_->drive(0.0, 0.0);
    const std::optional<Sighting> perch = nearestBlob(*camera_, taken_color_);
    memory_.time_unserved = perch && perch->distance() < kTaken ? 0.0 : memory_.time_unserved + dt_;
    if (memory_.time_unserved > kUnserved) {
      return enter(State::kSeek);
    }
    if (battery_->fraction() >= plenty_) {
      chooseLimit();
      enter(State::kWander);
    }
  }

  /// The nearest perch of a colour beside which no other robot shines.
  std::optional<Sighting> nearestUnattended(Color color) const {
    constexpr double kAttended = 0.45;  // m from a robot's LED to the perch
    std::optional<Sighting> nearest;
    for (const ColorBlob& blob : camera_->blobs) {
      const Sighting perch = sightingOf(blob);
      if (blob.color != color || (nearest && perch.distance() >= nearest->distance())) {
        continue;
      }
      const bool is_attended =
          std::any_of(camera_->blobs.begin(), camera_->blobs.end(), [&perch](const ColorBlob& other) {
            return other.color == kCharging && sightingOf(other).distanceTo(perch) < kAttended;
          });
      if (!is_attended) {
        nearest = perch;
      }
    }
    return nearest;
  }

  /// Turns away from obstacles ahead, and then drives on for some time, for a turn back at once would lead to the same
  /// obstacle. @return whether it does that
  bool isAvoiding() {
    constexpr double kThreshold = 0.05;
    constexpr double kHalfField = 1.5;  // rad: what is beside and behind does not count
    constexpr double kTurnRate = 1.5;   // rad/s
    const ObstacleVector obstacle(*proximity_, kHalfField);
    if (obstacle.length() > kThreshold) {
      if (memory_.avoiding_turn == 0.0) {  // a turn keeps its side: a corner would turn it to and fro
        memory_.avoiding_turn = obstacle.y > 0.0 ? -kTurnRate : kTurnRate;
        memory_.escape_left = robot_->random().uniform(0.5, 2.0);
      }
      wheels_->drive(0.0, memory_.avoiding_turn);
      return true;
    }
    memory_.avoiding_turn = 0.0;
    memory_.escape_left = std::max(0.0, memory_.escape_left - dt_);
    if (memory_.escape_left > 0.0) {
      wheels_->drive(speed_, 0.0);
      return true;
    }
    return false;
  }

  Robot* robot_ = nullptr;
  FootbotWheels* wheels_ = nullptr;
  FootbotLeds* leds_ = nullptr;
  const FootbotProximity* proximity_ = nullptr;
  const FootbotCamera* camera_ = nullptr;
  const Battery* battery_ = nullptr;
  double speed_ = 0.0;   // m/s
  double little_ = 0.0;  // part of the capacity below which it looks for a perch, at most
  double plenty_ = 0.0;  // part of it with which it leaves
  Color free_color_;
  Color taken_color_;
  double dt_ = 0.0;  // s

  /// All that steps keep for later steps.
  struct Memory {
    State state = State::kWander;
    bool has_looked = false;     // it has taken a step
    double limit = 0.0;          // part of the capacity below which it looks for a perch
    double turn_rate = 0.0;      // rad/s, while wandering
    double avoiding_turn = 0.0;  // rad/s, while it turns away from an obstacle
    double escape_left = 0.0;    // s of driving on after an obstacle
    double time_unserved = 0.0;  // s beside a perch that does not show that it charges
  };
  Memory memory_;
};

}  // namespace swarmanoid

REGISTER_CONTROLLER(swarmanoid::FootbotCharging, "footbot_charging")
