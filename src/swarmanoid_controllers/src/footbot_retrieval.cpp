// The footbots of the object retrieval experiment (thesis 4.3, figure 4.2): they wander until they see a laser spot, go
// to it, grip the prey beside it, turn blue and follow the spot. A footbot that sees blue keeps out of the way. A
// gripper reports only that it holds an object: a footbot that sees no prey ahead, or another blue footbot beside the
// prey, releases it.
#include <string>

#include "gripping.hpp"
#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/leds.hpp"

namespace swarmanoid {

class FootbotRetrieval final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    robot_ = &robot;
    wheels_ = &robot.actuator<FootbotWheels>();
    gripper_ = &robot.actuator<FootbotGripper>();
    leds_ = &robot.actuator<FootbotLeds>();
    proximity_ = &robot.sensor<FootbotProximity>();
    camera_ = &robot.sensor<FootbotCamera>();
    gripper_state_ = &robot.sensor<FootbotGripperState>();
    speed_ = parameters.number("speed", 0.15, {0.01, 0.3});
    // from the robot's axis to the axis of a gripped prey: 0.11 m to the tip, the prey's radius, and a margin
    prey_reach_ = parameters.number("prey_reach", 0.24, {0.11, 1.0});
    parameters.refuseUnread({"speed", "prey_reach"});
    reset();
  }

  void reset() override {
    memory_ = Memory{};
    *wheels_ = FootbotWheels{};
    enter(State::kSearchForLaser);
  }

  void step(Time, Duration dt) override {
    dt_ = toSeconds(dt);
    memory_.time_in_state += dt_;
    spot_ = nearestBlob(*camera_, colors::kRed);
    signaller_ = nearestBlob(*camera_, colors::kBlue);
    if (memory_.wiggle_time > 0.0) {
      memory_.wiggle_time -= dt_;
      return wheels_->drive(memory_.wiggle_speed, memory_.wiggle_turn_rate);
    }
    switch (memory_.state) {
      case State::kSearchForLaser:
        return searchForLaser();
      case State::kGoToLaser:
        return goToLaser();
      case State::kGripPrey:
        return gripPrey();
      case State::kGoToNest:
        return goToNest();
      case State::kAvoidGrippingFootbot:
        return avoidGrippingFootbot();
    }
  }

  void archive(StateArchive& state) override { state(memory_); }

 private:
  enum class State { kSearchForLaser, kGoToLaser, kGripPrey, kGoToNest, kAvoidGrippingFootbot };

  static const char* nameOf(State state) {
    switch (state) {
      case State::kSearchForLaser:
        return "Search for Laser";
      case State::kGoToLaser:
        return "Go to Laser";
      case State::kGripPrey:
        return "Grip Prey";
      case State::kGoToNest:
        return "Go to Nest";
      case State::kAvoidGrippingFootbot:
        return "Avoid Gripping Footbot";
    }
    return "";
  }

  void enter(State state) {
    memory_.state = state;
    memory_.time_in_state = 0.0;
    memory_.time_unseen = 0.0;
    memory_.time_in_vain = 0.0;
    memory_.jams = 0;
    memory_.retreat_time = 0.0;
    gripper_->closed = state == State::kGripPrey || state == State::kGoToNest;
    leds_->setAll(state == State::kGoToNest ? colors::kBlue : colors::kBlack);
    robot_->debug("state", nameOf(state));
  }

  /// Leaves after a failed grip, so that the footbots around the prey do not block each other.
  void letGo() {
    enter(State::kSearchForLaser);
    memory_.retreat_time = robot_->random().uniform(2.0, 10.0);
  }

  void searchForLaser() {
    constexpr double kBackwards = 1.0;  // s
    const bool is_retreating = memory_.time_in_state < memory_.retreat_time;
    if (is_retreating && memory_.time_in_state < kBackwards) {
      return wheels_->drive(-speed_, 0.0);
    }
    if (signaller_) {
      return enter(State::kAvoidGrippingFootbot);
    }
    if (spot_ && !is_retreating) {
      return enter(State::kGoToLaser);
    }
    wander();
  }

  void goToLaser() {
    constexpr double kNearSpot = 0.45;  // m: the distance at which the footbot looks for the prey at the spot
    constexpr double kGiveUp = 3.0;     // s without seeing the spot
    if (signaller_) {
      return enter(State::kAvoidGrippingFootbot);
    }
    if (!spot_) {
      memory_.time_unseen += dt_;
      if (memory_.time_unseen > kGiveUp) {
        return enter(State::kSearchForLaser);
      }
      return wander();
    }
    memory_.time_unseen = 0.0;
    if (spot_->distance() < kNearSpot && preyAtSpot()) {
      return enter(State::kGripPrey);
    }
    if (!avoidObstacle()) {
      steer(*wheels_, spot_->bearing(), speed_);
    }
  }

  void gripPrey() {
    constexpr double kGiveUp = 20.0;  // s
    if (gripper_state_->gripping) {
      enter(State::kGoToNest);
      // two footbots that grip one prey have different patience, so that one of them keeps the prey
      memory_.patience = robot_->random().uniform(1.0, 4.0);
      return;
    }
    if (signaller_) {
      return enter(State::kAvoidGrippingFootbot);
    }
    const std::optional<Sighting> prey = preyAtSpot();
    if (!prey || memory_.time_in_state > kGiveUp) {
      return letGo();
    }
    driveToGrip(*wheels_, *prey, prey_reach_, speed_, 0.3 * speed_);
  }

  void goToNest() {
    constexpr double kArrived = 0.15;    // m: the spot lies on the prey
    constexpr double kBehindPrey = 3.0;  // s: the prey hides a spot that is straight ahead
    constexpr double kGiveUp = 30.0;     // s without seeing the spot
    if (!gripper_state_->gripping) {
      return enter(State::kSearchForLaser);
    }
    if (holdsInVain() || memory_.time_unseen > kGiveUp || memory_.jams > kMostJams) {
      return letGo();
    }
    if (memory_.time_in_vain > 0.0) {
      return wheels_->drive(0.0, 0.0);
    }
    if (spot_) {
      memory_.time_unseen = 0.0;
      memory_.last_bearing = spot_->bearing();
      if (spot_->distance() < kArrived) {
        wheels_->drive(0.0, 0.0);
      } else {
        steer(*wheels_, memory_.last_bearing, 0.6 * speed_);
        noticeJam(spot_->distance());
      }
      return;
    }
    memory_.time_unseen += dt_;
    if (memory_.time_unseen < kBehindPrey && std::abs(memory_.last_bearing) < 0.5) {
      wheels_->drive(0.3 * speed_, 0.0);
    } else {
      wheels_->drive(0.0, memory_.last_bearing < 0.0 ? -0.5 : 0.5);
    }
  }

  /// Returns whether for some time there has been no prey at the gripper, so that it holds another footbot, or whether
  /// another blue footbot has been beside the prey and holds it too.
  bool holdsInVain() {
    const std::optional<Sighting> prey = preyInGripper();
    const bool is_mine = prey && !(signaller_ && signaller_->distanceTo(*prey) < prey_reach_);
    memory_.time_in_vain = is_mine ? 0.0 : memory_.time_in_vain + dt_;
    return memory_.time_in_vain > memory_.patience;
  }

  void avoidGrippingFootbot() {
    constexpr double kRoom = 1.0;  // m of distance to the signalling footbot
    constexpr double kCalm = 2.0;  // s without blue
    if (!signaller_) {
      memory_.time_unseen += dt_;
      if (memory_.time_unseen > kCalm) {
        return enter(State::kSearchForLaser);
      }
      return wander();
    }
    memory_.time_unseen = 0.0;
    if (avoidObstacle()) {
      return;
    }
    if (signaller_->distance() < kRoom) {
      steer(*wheels_, wrapAngle(signaller_->bearing() + M_PI), speed_);
    } else {
      wheels_->drive(0.0, 0.0);
    }
  }

  static bool isPrey(const ColorBlob& blob) { return blob.color != colors::kRed && blob.color != colors::kBlue; }

  /// Returns the prey that the laser points at, whatever its colour.
  std::optional<Sighting> preyAtSpot() const {
    constexpr double kAtSpot = 0.15;  // m
    std::optional<Sighting> nearest;
    if (spot_) {
      for (const ColorBlob& blob : camera_->blobs) {
        const Sighting sighting = sightingOf(blob);
        const double distance = sighting.distanceTo(*spot_);
        if (isPrey(blob) && distance < kAtSpot && (!nearest || distance < nearest->distanceTo(*spot_))) {
          nearest = sighting;
        }
      }
    }
    return nearest;
  }

  /// Returns the object that a closed gripper may hold: the nearest prey ahead within its reach.
  std::optional<Sighting> preyInGripper() const {
    constexpr double kAhead = 0.5;  // rad
    std::optional<Sighting> nearest;
    for (const ColorBlob& blob : camera_->blobs) {
      const Sighting sighting = sightingOf(blob);
      const bool is_reached = sighting.distance() < prey_reach_ && std::abs(sighting.bearing()) < kAhead;
      if (isPrey(blob) && is_reached && (!nearest || sighting.distance() < nearest->distance())) {
        nearest = sighting;
      }
    }
    return nearest;
  }

  void wander() {
    if (avoidObstacle()) {
      return;
    }
    memory_.turn_rate = wanderingTurnRate(robot_->random(), memory_.turn_rate, dt_);
    wheels_->drive(speed_, memory_.turn_rate);
  }

  /// Turns away from obstacles ahead in the proximity readings. @return whether there was an obstacle
  bool avoidObstacle() {
    constexpr double kThreshold = 0.05;
    constexpr double kTurnRate = 1.5;  // rad/s
    constexpr double kJammed = 3.0;    // s: a free robot has turned away by then
    const ObstacleVector obstacle(*proximity_);
    if (obstacle.length() < kThreshold || obstacle.x < 0.0) {
      memory_.time_avoiding = 0.0;
      return false;
    }
    memory_.time_avoiding += dt_;
    if (memory_.time_avoiding > kJammed) {
      memory_.time_avoiding = 0.0;
      wiggle();
    }
    wheels_->drive(0.0, obstacle.y > 0.0 ? -kTurnRate : kTurnRate);
    return true;
  }

  /// Drives in a random direction for a moment: this resolves a jam between robots whose cause is unknown.
  void wiggle() {
    memory_.wiggle_time = robot_->random().uniform(0.5, 1.5);
    memory_.wiggle_speed = robot_->random().uniform(-speed_, 0.5 * speed_);
    memory_.wiggle_turn_rate = robot_->random().uniform(-1.5, 1.5);
  }

  /// Detects a jam: a distance to the waiting spot that does not decrease means that the way is blocked. If wiggling
  /// does not help, the held object is the obstacle.
  void noticeJam(double spot_distance) {
    constexpr double kNearer = 0.02;  // m
    constexpr double kJammed = 8.0;   // s
    if (spot_distance < memory_.best_distance - kNearer || spot_distance > memory_.best_distance + 0.2) {
      memory_.best_distance = spot_distance;
      memory_.time_barred = 0.0;
      memory_.jams = 0;
    }
    memory_.time_barred += dt_;
    if (memory_.time_barred > kJammed) {
      memory_.time_barred = 0.0;
      ++memory_.jams;
      wiggle();
    }
  }

  static constexpr int kMostJams = 3;

  Robot* robot_ = nullptr;
  FootbotWheels* wheels_ = nullptr;
  FootbotGripper* gripper_ = nullptr;
  FootbotLeds* leds_ = nullptr;
  const FootbotProximity* proximity_ = nullptr;
  const FootbotCamera* camera_ = nullptr;
  const FootbotGripperState* gripper_state_ = nullptr;
  double speed_ = 0.0;       // m/s
  double prey_reach_ = 0.0;  // m

  /// State that is kept between steps; a reset clears it.
  struct Memory {
    State state = State::kSearchForLaser;
    double time_in_state = 0.0;     // s
    double time_unseen = 0.0;       // s in which the target of the state is not in sight
    double retreat_time = 0.0;      // s at the start of Search for Laser in which the spot is ignored
    double time_avoiding = 0.0;     // s of turning away without success
    double time_barred = 0.0;       // s since the distance to the spot last decreased
    double best_distance = 0.0;     // m to the spot, at the last progress
    double time_in_vain = 0.0;      // s of holding an object that cannot be brought home
    double patience = 0.0;          // s of holding in vain until the footbot gives up
    int jams = 0;                   // count since the distance to the spot last decreased
    double wiggle_time = 0.0;       // s left
    double wiggle_speed = 0.0;      // m/s
    double wiggle_turn_rate = 0.0;  // rad/s
    double turn_rate = 0.0;         // rad/s, while wandering
    double last_bearing = 0.0;      // rad, of the spot
  };
  Memory memory_;

  // of this step
  double dt_ = 0.0;  // s
  std::optional<Sighting> spot_;
  std::optional<Sighting> signaller_;
};

}  // namespace swarmanoid

REGISTER_CONTROLLER(swarmanoid::FootbotRetrieval, "footbot_retrieval")
