// A footbot that finds its way by marks that others leave on the floor (stigmergy): it follows a trail, which is darker
// than floor patches, and turns round on a patch. At a gap in the trail it goes straight on, then searches on the spot.
// Without a trail it wanders.
#include <cmath>

#include "differential_drive.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/footbot_ground.hpp"

namespace swarmanoid {

class TrailFollowing final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    robot_ = &robot;
    wheels_ = &robot.actuator<FootbotWheels>();
    proximity_ = &robot.sensor<FootbotProximity>();
    ground_ = &robot.sensor<FootbotGround>();
    speed_ = parameters.number("speed", 0.12, {0.01, 0.3});
    patch_ = parameters.number("patch", 2.0 / 3.0, {0.0, 1.0});
    parameters.refuseUnread({"speed", "patch"});
    reset();
  }

  void reset() override {
    memory_ = Memory{};
    drive("Wander", 0.0, 0.0);
  }

  void step(Time, Duration dt) override {
    dt_ = toSeconds(dt);
    memory_.since_patch += dt_;
    if (memory_.turn_left > 0.0) {
      memory_.turn_left -= dt_;
      return drive("Turn Round", 0.0, kTurnRate * memory_.side);
    }
    const ObstacleVector obstacles(*proximity_, 0.5 * M_PI);
    if (obstacles.length() > kNear) {
      return avoid(obstacles);
    }
    if (isOnPatch() && memory_.since_patch > kLeaving) {
      memory_.since_patch = 0.0;
      memory_.turn_left = M_PI / kTurnRate;
      return;
    }
    follow();
  }

  void archive(StateArchive& state) override { state(memory_); }

 private:
  static constexpr double kTurnRate = 1.5;  // rad/s
  static constexpr double kNear = 0.15;     // of the sum of proximity readings
  static constexpr double kMargin = 0.05;   // of a reading
  static constexpr double kLeaving = 6.0;   // s after arrival on a patch; the turn takes 2 of them
  static constexpr double kGap = 1.6;       // s of driving straight on at a gap in the trail
  static constexpr double kSearch = 6.0;    // s, for the gap and the search on the spot

  /// The part of the four spots in front that is darker than a patch.
  struct Trail {
    double darkness = 0.0;
    double side = 0.0;  // from -1, right, to 1, left
  };

  Trail look() const {
    Trail trail;
    for (std::size_t i = 0; i < FootbotGround::kCount; ++i) {
      const double darkness = patch_ - kMargin - ground_->value[i];
      const Eigen::Vector2d place = FootbotGround::place(i);
      if (darkness > 0.0 && place.x() > 0.0) {
        trail.darkness += darkness;
        trail.side += darkness * place.y() / FootbotGround::kRingRadius;
      }
    }
    trail.side /= trail.darkness > 0.0 ? trail.darkness : 1.0;
    return trail;
  }

  bool readsPatch(std::size_t spot) const { return std::abs(ground_->value[spot] - patch_) < kMargin; }

  bool isPatchAhead() const { return readsPatch(0) && readsPatch(FootbotGround::kCount - 1); }

  /// At least half of the spots read the patch, and none reads a brighter floor; the others may be over a trail.
  bool isOnPatch() const {
    std::size_t patch = 0;
    for (std::size_t i = 0; i < FootbotGround::kCount; ++i) {
      if (ground_->value[i] > patch_ + kMargin) {
        return false;
      }
      patch += readsPatch(i) ? 1 : 0;
    }
    return patch >= FootbotGround::kCount / 2;
  }

  /// Robots that meet on a trail both keep to the right, and search for it on the left afterwards.
  void avoid(const ObstacleVector& obstacles) {
    constexpr double kRightmost = -0.4;  // rad
    const double side = obstacles.bearing() > kRightmost ? 1.0 : -1.0;
    if (memory_.lost_for < kSearch) {
      memory_.lost_for = 0.0;
      memory_.side = side;
    }
    memory_.turn_rate = -0.8 * side;  // of the arc that leads away, if it wanders next
    drive("Avoid", 0.3 * speed_, -kTurnRate * side);
  }

  void follow() {
    constexpr double kGain = 2.5;  // 1/s
    const Trail trail = look();
    if (trail.darkness > 0.0) {
      memory_.lost_for = 0.0;
      memory_.side = trail.side > 0.0 ? 1.0 : -1.0;
      return drive("Follow", (1.0 - 0.7 * std::abs(trail.side)) * speed_, kGain * trail.side);
    }
    memory_.lost_for += dt_;
    if (memory_.lost_for < kGap || memory_.since_patch < kLeaving || isPatchAhead()) {
      return drive("Go On", speed_, 0.0);
    }
    if (memory_.lost_for < kSearch) {
      return drive("Search", 0.0, 0.8 * kTurnRate * memory_.side);
    }
    memory_.turn_rate = wanderingTurnRate(robot_->random(), memory_.turn_rate, dt_);
    drive("Wander", speed_, memory_.turn_rate);
  }

  void drive(const char* state, double speed, double turn_rate) {
    wheels_->drive(speed, turn_rate);
    robot_->debug("state", state);
  }

  /// State that a reset clears.
  struct Memory {
    double turn_left = 0.0;    // s, on a patch
    double since_patch = 1e9;  // s
    double lost_for = 1e9;     // s since there was a trail or an obstacle on it
    double side = 1.0;         // of the last trail: 1 left, -1 right
    double turn_rate = 0.0;    // rad/s, while it wanders
  };

  Robot* robot_ = nullptr;
  FootbotWheels* wheels_ = nullptr;
  const FootbotProximity* proximity_ = nullptr;
  const FootbotGround* ground_ = nullptr;
  double speed_ = 0.0;  // m/s
  double patch_ = 0.0;  // the reading over a floor patch
  double dt_ = 0.0;     // s
  Memory memory_;
};

}  // namespace swarmanoid

REGISTER_CONTROLLER(swarmanoid::TrailFollowing, "trail_following")
