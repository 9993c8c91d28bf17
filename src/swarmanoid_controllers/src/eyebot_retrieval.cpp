// The eyebot of the object retrieval experiment (thesis 4.3, figure 4.3): picks a prey, finds it, points at it with the
// laser until a footbot has gripped it, then finds the nest and leads the footbot there. If the footbot releases the
// prey on the way, the eyebot starts over.
#include <algorithm>
#include <string>
#include <vector>

#include "blob_search.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/eyebot_laser.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"

namespace swarmanoid {

class EyebotRetrieval final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    robot_ = &robot;
    velocity_ = &robot.actuator<EyebotVelocity>();
    laser_ = &robot.actuator<EyebotLaser>();
    camera_ = &robot.sensor<EyebotCamera>();
    speed_ = parameters.number("speed", 0.3, {0.01, 1.0});
    lead_speed_ = parameters.number("lead_speed", 0.08, {0.01, 1.0});
    search_radius_ = parameters.number("search_radius", 1.2, {0.0, 100.0});
    altitude_ = parameters.number("altitude", 2.0, {0.1, 100.0});
    for (const char* key : {"prey_color_1", "prey_color_2"}) {
      prey_colors_.push_back(parameters.color(key));
    }
    nest_color_ = parameters.color("nest_color", colors::kGreen);
    parameters.refuseUnread(
        {"speed", "lead_speed", "search_radius", "altitude", "prey_color_1", "prey_color_2", "nest_color"});
    reset();
  }

  void reset() override {
    has_chosen_ = false;
    flown_ = Sighting{};
    waypoint_ = Sighting{};
    nest_place_.reset();
    *velocity_ = EyebotVelocity{};
    *laser_ = EyebotLaser{};
    enter(State::kSearchForPrey);
  }

  void step(Time, Duration dt) override {
    dt_ = toSeconds(dt);
    if (!has_chosen_) {
      has_chosen_ = true;
      prey_color_ = prey_colors_[robot_->random().below(prey_colors_.size())];
      robot_->debug("prey", toString(prey_color_));
    }
    velocity_->linear.setZero();
    switch (state_) {
      case State::kSearchForPrey:
        searchForPrey();
        break;
      case State::kGoToPrey:
        goToPrey();
        break;
      case State::kWaitForFootbotGripping:
        waitForFootbotGripping();
        break;
      case State::kSearchForNest:
        searchForNest();
        break;
      case State::kGoToNest:
        goToNest();
        break;
    }
    // the displacement from the start, estimated from the eyebot's own commands
    flown_.x += velocity_->linear.x() * dt_;
    flown_.y += velocity_->linear.y() * dt_;
  }

  void archive(StateArchive& state) override {
    state(state_, has_chosen_, prey_color_, time_alone_, flown_, waypoint_, nest_place_);
  }

 private:
  enum class State { kSearchForPrey, kGoToPrey, kWaitForFootbotGripping, kSearchForNest, kGoToNest };

  static const char* nameOf(State state) {
    switch (state) {
      case State::kSearchForPrey:
        return "Search for Prey";
      case State::kGoToPrey:
        return "Go to Prey";
      case State::kWaitForFootbotGripping:
        return "Wait for Footbot Gripping";
      case State::kSearchForNest:
        return "Search for Nest";
      case State::kGoToNest:
        return "Go to Nest";
    }
    return "";
  }

  void enter(State state) {
    state_ = state;
    time_alone_ = 0.0;
    laser_->on = state != State::kSearchForPrey;
    laser_->tilt = 0.0;
    robot_->debug("state", nameOf(state));
  }

  void searchForPrey() {
    if (nearestBlob(*camera_, prey_color_)) {
      return enter(State::kGoToPrey);
    }
    flyAround(speed_);
  }

  void goToPrey() {
    constexpr double kAbove = 0.05;  // m
    const auto prey = nearestBlob(*camera_, prey_color_);
    if (!prey) {
      return enter(State::kSearchForPrey);
    }
    pointAt(*prey);
    flyTo(*prey, speed_);
    if (isGripped(*prey)) {
      enter(State::kSearchForNest);
    } else if (prey->distance() < kAbove) {
      enter(State::kWaitForFootbotGripping);
    }
  }

  void waitForFootbotGripping() {
    const auto prey = nearestBlob(*camera_, prey_color_);
    if (!prey) {
      return enter(State::kSearchForPrey);
    }
    pointAt(*prey);
    flyTo(*prey, speed_);
    if (isGripped(*prey)) {
      enter(State::kSearchForNest);
    }
  }

  void searchForNest() {
    if (isLeftAlone()) {
      return enter(State::kSearchForPrey);
    }
    if (nearestBlob(*camera_, nest_color_)) {
      return enter(State::kGoToNest);
    }
    if (isFollowed()) {
      // the eyebot first flies to the last seen place of the nest, such as at the edge of the view
      if (nest_place_) {
        waypoint_ = *nest_place_;
        nest_place_.reset();
      }
      flyAround(lead_speed_);
    }
  }

  void goToNest() {
    if (isLeftAlone()) {
      return enter(State::kSearchForPrey);
    }
    const auto nest = nearestBlob(*camera_, nest_color_);
    if (!nest) {
      return enter(State::kSearchForNest);
    }
    nest_place_ = Sighting{flown_.x + nest->x, flown_.y + nest->y};
    if (isFollowed()) {
      flyTo(*nest, lead_speed_);
    }
  }

  /// Returns whether a blue footbot is beside the prey.
  bool isGripped(const Sighting& prey) const {
    constexpr double kHoldsPrey = 0.5;  // m from the prey to the footbot
    const auto footbot = middleOfBlobs(*camera_, colors::kBlue);
    return footbot && footbot->distanceTo(prey) < kHoldsPrey;
  }

  /// Returns whether no blue footbot has been in sight for some time: a footbot that holds a prey always stays within
  /// the eyebot's view, because it must see the spot.
  bool isLeftAlone() {
    constexpr double kGiveUp = 5.0;  // s
    time_alone_ = nearestBlob(*camera_, colors::kBlue) ? 0.0 : time_alone_ + dt_;
    return time_alone_ > kGiveUp;
  }

  /// Returns whether the blue footbot is near enough to the spot, which is straight below, to continue. Without a
  /// footbot in sight the eyebot waits for it (thesis 4.3).
  bool isFollowed() const {
    constexpr double kLead = 0.5;  // m from the footbot to the spot
    const auto footbot = middleOfBlobs(*camera_, colors::kBlue);
    return footbot && footbot->distance() < kLead;
  }

  void pointAt(const Sighting& target) {
    constexpr double kPreyHeight = 0.1;  // m
    laser_->pan = target.bearing();
    laser_->tilt = std::atan2(target.distance(), altitude_ - kPreyHeight);
  }

  void flyTo(const Sighting& target, double speed) {
    constexpr double kGain = 1.0;  // 1/s
    const double distance = target.distance();
    if (distance > 0.0) {
      const double wanted = std::min(speed, kGain * distance);
      velocity_->linear.x() = wanted * target.x / distance;
      velocity_->linear.y() = wanted * target.y / distance;
    }
  }

  /// Flies from one random place to the next, around the start.
  void flyAround(double speed) {
    constexpr double kReached = 0.1;  // m
    Sighting way{waypoint_.x - flown_.x, waypoint_.y - flown_.y};
    if (way.distance() < kReached) {
      waypoint_ = {robot_->random().uniform(-search_radius_, search_radius_),
                   robot_->random().uniform(-search_radius_, search_radius_)};
      way = {waypoint_.x - flown_.x, waypoint_.y - flown_.y};
    }
    flyTo(way, speed);
  }

  Robot* robot_ = nullptr;
  EyebotVelocity* velocity_ = nullptr;
  EyebotLaser* laser_ = nullptr;
  const EyebotCamera* camera_ = nullptr;
  double speed_ = 0.0;          // m/s
  double lead_speed_ = 0.0;     // m/s
  double search_radius_ = 0.0;  // m
  double altitude_ = 0.0;       // m
  std::vector<Color> prey_colors_;
  Color nest_color_;

  State state_ = State::kSearchForPrey;
  bool has_chosen_ = false;
  Color prey_color_;
  double dt_ = 0.0;                     // s
  double time_alone_ = 0.0;             // s since a blue footbot was in sight
  Sighting flown_;                      // from the start, in the frame of the start
  Sighting waypoint_;                   // in the frame of the start
  std::optional<Sighting> nest_place_;  // last seen position of the nest, in the frame of the start
};

}  // namespace swarmanoid

REGISTER_CONTROLLER(swarmanoid::EyebotRetrieval, "eyebot_retrieval")
