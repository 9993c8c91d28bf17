/// How a footbot forages alone: it wanders until it sees a free prey, grips it, carries it to the nest, which it
/// recognizes by its colour, releases it and turns away. Its LEDs are blue while it holds a prey, and other robots
/// ignore prey near that light.
#pragma once

#include "distinct_colors.hpp"
#include "gripping.hpp"
#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/leds.hpp"

namespace swarmanoid {

class PreyRetrieval {
 public:
  /// @param speed of the robot [m/s]
  void init(Robot& robot, const Configuration& parameters, double speed) {
    robot_ = &robot;
    wheels_ = &robot.actuator<FootbotWheels>();
    gripper_ = &robot.actuator<FootbotGripper>();
    leds_ = &robot.actuator<FootbotLeds>();
    proximity_ = &robot.sensor<FootbotProximity>();
    camera_ = &robot.sensor<FootbotCamera>();
    gripper_state_ = &robot.sensor<FootbotGripperState>();
    speed_ = speed;
    prey_color_ = parameters.color("prey_color", colors::kYellow);
    nest_color_ = parameters.color("nest_color", colors::kGreen);
  }

  /// Colours that must differ from each other and from all others that the robot recognizes (distinct_colors.hpp). @pre
  /// init
  std::vector<NamedColor> colors() const {
    return {{"the light of whoever carries", kCarrying}, {"prey_color", prey_color_}, {"nest_color", nest_color_}};
  }

  /// Starts to search for a prey, with empty gripper.
  void begin() {
    memory_ = Memory{};
    enter(State::kSearch);
  }
  void archive(StateArchive& state) { state(memory_); }
  bool isSearching() const { return memory_.state == State::kSearch; }

  /// @param dt since the last call [s]
  void step(double dt) {
    dt_ = dt;
    memory_.time_in_state += dt_;
    switch (memory_.state) {
      case State::kSearch:
        return search();
      case State::kGrip:
        return grip();
      case State::kCarry:
        return carry();
      case State::kTurnAway:
        return turnAway();
    }
  }

 private:
  enum class State { kSearch, kGrip, kCarry, kTurnAway };

  static constexpr Color kCarrying = colors::kBlue;
  static constexpr double kFar = 1e3;         // m
  static constexpr double kTurnRate = 1.5;    // rad/s
  static constexpr double kNearPrey = 0.4;    // m: below this distance the prey itself does not count as an obstacle
  static constexpr double kPreyReach = 0.24;  // m from the robot's axis to the axis of a gripped prey, plus a margin

  static const char* nameOf(State state) {
    switch (state) {
      case State::kSearch:
        return "Search";
      case State::kGrip:
        return "Grip";
      case State::kCarry:
        return "Carry";
      case State::kTurnAway:
        return "Turn Away";
    }
    return "";
  }

  void enter(State state) {
    const double turn_rate = memory_.turn_rate;
    memory_ = Memory{};
    memory_.state = state;
    memory_.turn_rate = turn_rate;
    if (state == State::kGrip || state == State::kCarry) {
      // neighbours that block each other give up at different times
      memory_.patience = robot_->random().uniform(3.0, 6.0);
    }
    gripper_->closed = state == State::kGrip || state == State::kCarry;
    leds_->setAll(state == State::kCarry ? kCarrying : colors::kBlack);
    robot_->debug("state", nameOf(state));
  }

  void search() {
    constexpr double kEscape = 1.0;  // s
    const std::optional<Sighting> prey = nearestFreePrey();
    if (prey && prey->distance() < kNearPrey) {
      return enter(State::kGrip);
    }
    if (avoidObstacle()) {
      memory_.escape_left = kEscape;
      return;
    }
    if (memory_.escape_left > 0.0) {  // a turn back at once would lead to the same obstacle
      memory_.escape_left -= dt_;
      return wheels_->drive(speed_, 0.0);
    }
    if (prey) {
      return steer(*wheels_, prey->bearing(), speed_);
    }
    memory_.turn_rate = wanderingTurnRate(robot_->random(), memory_.turn_rate, dt_);
    wheels_->drive(speed_, memory_.turn_rate);
  }

  void grip() {
    constexpr double kApproach = 5.0;  // s, duration of an unhindered approach
    if (gripper_state_->gripping) {
      return enter(State::kCarry);
    }
    const std::optional<Sighting> prey = nearestFreePrey();
    if (!prey || prey->distance() > kNearPrey + 0.1 || memory_.time_in_state > kApproach + memory_.patience) {
      return enter(State::kTurnAway);
    }
    driveToGrip(*wheels_, *prey, kPreyReach, speed_, 0.5 * speed_);
  }

  void carry() {
    constexpr double kArrived = 0.25;  // m: the prey is well inside the nest
    constexpr int kMostJams = 2;
    if (!gripper_state_->gripping || holdsNoPrey()) {
      return enter(State::kTurnAway);  // the prey was taken away
    }
    const std::optional<Sighting> nest = nearestBlob(*camera_, nest_color_);
    if (nest && nest->distance() < kArrived) {
      return enter(State::kTurnAway);
    }
    noticeJam(nest ? nest->distance() : memory_.best_distance);
    if (memory_.jams > kMostJams) {
      return enter(State::kTurnAway);
    }
    if (memory_.dodge_left > 0.0) {
      memory_.dodge_left -= dt_;
      return wheels_->drive(-0.3 * speed_, memory_.dodge_turn);
    }
    if (nest) {
      steer(*wheels_, nest->bearing(), 0.8 * speed_);
    } else {
      wheels_->drive(0.5 * speed_, 0.5);  // the robot that hides the nest moves on, or this one does
    }
  }

  /// Backs off from the object it held, then turns in a new direction.
  void turnAway() {
    constexpr double kBackwards = 1.0;  // s
    if (memory_.time_in_state <= kBackwards) {
      return wheels_->drive(-0.5 * speed_, 0.0);
    }
    if (memory_.turn_left == 0.0) {
      memory_.turn_left = robot_->random().uniform(0.6 * M_PI, 1.4 * M_PI);
    }
    memory_.turn_left -= kTurnRate * dt_;
    if (memory_.turn_left <= 0.0) {
      return enter(State::kSearch);
    }
    wheels_->drive(0.0, kTurnRate);
  }

  /// The gripper reports any gripped object, even a robot. @return whether no prey was seen ahead for some time
  bool holdsNoPrey() {
    constexpr double kAhead = 0.5;     // rad
    constexpr double kSurelyIn = 1.0;  // s
    bool is_ahead = false;
    for (const ColorBlob& blob : camera_->blobs) {
      is_ahead = is_ahead || (blob.color == prey_color_ && blob.distance < kPreyReach &&
                              std::abs(static_cast<double>(blob.bearing)) < kAhead);
    }
    memory_.time_without_prey = is_ahead ? 0.0 : memory_.time_without_prey + dt_;
    return memory_.time_without_prey > kSurelyIn;
  }

  /// No progress towards the nest means that an obstacle blocks the way: the robot backs off to a random side and tries
  /// again.
  void noticeJam(double nest_distance) {
    constexpr double kNearer = 0.02;  // m
    constexpr double kDodge = 1.5;    // s
    memory_.time_barred += dt_;
    if (nest_distance < memory_.best_distance - kNearer) {
      memory_.best_distance = nest_distance;
      memory_.time_barred = 0.0;
    }
    if (memory_.time_barred > memory_.patience) {
      memory_.time_barred = 0.0;
      memory_.best_distance = kFar;
      ++memory_.jams;
      memory_.dodge_left = kDodge;
      memory_.dodge_turn = robot_->random().uniform(-1.0, 1.0);
    }
  }

  /// The nearest prey without the blue light of a carrier near it.
  std::optional<Sighting> nearestFreePrey() const {
    constexpr double kHeldWithin = 0.3;  // m from an LED of its carrier
    std::optional<Sighting> nearest;
    for (const ColorBlob& blob : camera_->blobs) {
      const Sighting prey = sightingOf(blob);
      if (blob.color != prey_color_ || (nearest && prey.distance() >= nearest->distance())) {
        continue;
      }
      bool is_held = false;
      for (const ColorBlob& other : camera_->blobs) {
        is_held = is_held || (other.color == kCarrying && sightingOf(other).distanceTo(prey) < kHeldWithin);
      }
      if (!is_held) {
        nearest = prey;
      }
    }
    return nearest;
  }

  /// Turns away from obstacles ahead; a turn keeps its side, because in a corner it would oscillate otherwise.
  /// @return whether there was an obstacle
  bool avoidObstacle() {
    constexpr double kThreshold = 0.05;
    constexpr double kHalfField = 1.5;  // rad: obstacles beside and behind the robot do not count
    const ObstacleVector obstacle(*proximity_, kHalfField);
    if (obstacle.length() <= kThreshold) {
      memory_.avoiding_turn = 0.0;
      return false;
    }
    if (memory_.avoiding_turn == 0.0) {
      memory_.avoiding_turn = obstacle.y > 0.0 ? -kTurnRate : kTurnRate;
    }
    wheels_->drive(0.0, memory_.avoiding_turn);
    return true;
  }

  Robot* robot_ = nullptr;
  FootbotWheels* wheels_ = nullptr;
  FootbotGripper* gripper_ = nullptr;
  FootbotLeds* leds_ = nullptr;
  const FootbotProximity* proximity_ = nullptr;
  const FootbotCamera* camera_ = nullptr;
  const FootbotGripperState* gripper_state_ = nullptr;
  double speed_ = 0.0;  // m/s
  Color prey_color_;
  Color nest_color_;
  double dt_ = 0.0;  // s

  /// State that is kept between steps; entering a state clears it.
  struct Memory {
    State state = State::kSearch;
    double time_in_state = 0.0;      // s
    double patience = 0.0;           // s
    double turn_rate = 0.0;          // rad/s, while wandering; kept across states
    double avoiding_turn = 0.0;      // rad/s, while turning away from an obstacle
    double turn_left = 0.0;          // rad that remain of turning away
    double time_without_prey = 0.0;  // s of holding another object
    double time_barred = 0.0;        // s without progress towards the nest
    double best_distance = kFar;     // m to the nest, at the last progress
    int jams = 0;                    // since it began to carry
    double dodge_left = 0.0;         // s
    double dodge_turn = 0.0;         // rad/s
    double escape_left = 0.0;        // s of driving straight on after an obstacle
  };
  Memory memory_;
};

}  // namespace swarmanoid
