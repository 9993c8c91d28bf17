/// How a footbot forages alone: it wanders until it sees a prey that nobody holds, grips it, carries it to the nest,
/// which it sees by its colour, lets go and turns away. While it holds a prey it shines blue, and whoever sees that
/// leaves the prey alone.
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

  /// Which must all be different, and from those of whatever else the robot knows (distinct_colors.hpp). @pre init
  std::vector<NamedColor> colors() const {
    return {{"the light of whoever carries", kCarrying}, {"prey_color", prey_color_}, {"nest_color", nest_color_}};
  }

  /// It holds nothing, and looks for a prey.
  void begin() {
    memory_ = Memory{};
    enter(State::kSearch);
  }
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
  static constexpr double kNearPrey = 0.4;    // m: from here on the prey itself is no obstacle
  static constexpr double kPreyReach = 0.24;  // m from the robot's axis to that of a gripped prey, and a margin

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
      // neighbours that are in each other's way for the same reason give up at different times
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
    constexpr double kApproach = 5.0;  // s that a robot takes which nobody hinders
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
    constexpr double kArrived = 0.25;  // m: the prey lies well within the nest
    constexpr int kMostJams = 2;
    if (!gripper_state_->gripping || holdsNoPrey()) {
      return enter(State::kTurnAway);  // it was taken away
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
      wheels_->drive(0.5 * speed_, 0.5);  // whoever hides it moves on, or it does
    }
  }

  /// Backs off from what it held, and turns to where it has not been.
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

  /// A gripper reports that it holds something, which may be a robot. @return whether for some time there was no prey
  /// ahead
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

  /// While the nest comes no nearer something is in the way: the robot backs off to a side of chance, and tries again.
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

  /// The nearest prey that nobody who shines blue may hold.
  std::optional<Sighting> nearestFreePrey() const {
    constexpr double kHeldWithin = 0.3;  // m from an LED of who holds it
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

  /// Turns away from obstacles ahead; a turn keeps its side, for a corner would turn it to and fro.
  /// @return whether there was an obstacle
  bool avoidObstacle() {
    constexpr double kThreshold = 0.05;
    constexpr double kHalfField = 1.5;  // rad: what is beside and behind does not count
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

  /// All that steps keep for later steps; a new state clears it.
  struct Memory {
    State state = State::kSearch;
    double time_in_state = 0.0;      // s
    double patience = 0.0;           // s
    double turn_rate = 0.0;          // rad/s, while wandering; kept from state to state
    double avoiding_turn = 0.0;      // rad/s, while it turns away from an obstacle
    double turn_left = 0.0;          // rad, of turning away
    double time_without_prey = 0.0;  // s of holding something else
    double time_barred = 0.0;        // s since it last came nearer to the nest
    double best_distance = kFar;     // m to the nest, when this distance last changed
    int jams = 0;                    // since it carries
    double dodge_left = 0.0;         // s
    double dodge_turn = 0.0;         // rad/s
    double escape_left = 0.0;        // s of driving on after an obstacle
  };
  Memory memory_;
};

}  // namespace swarmanoid
