// Chain formation, after Nouyan and Dorigo, "Chain based path formation in swarms of robots", ANTS 2006: footbots that
// see no farther than their neighbours form a chain from the nest to a prey. A robot explores along the chain. At its
// end the robot joins at random; the last link leaves at random and explores again. Links shine in three colours in
// turn, so two visible links give a robot the direction of the nest.
#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "blob_search.hpp"
#include "differential_drive.hpp"
#include "distinct_colors.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/footbot_beacon.hpp"

namespace swarmanoid {

class ChainFormation final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    robot_ = &robot;
    wheels_ = &robot.actuator<FootbotWheels>();
    beacon_ = &robot.actuator<FootbotBeacon>();
    proximity_ = &robot.sensor<FootbotProximity>();
    camera_ = &robot.sensor<FootbotCamera>();
    speed_ = parameters.number("speed", 0.15, {0.01, 0.3});
    distance_ = parameters.number("distance", 0.65, {0.3, 10.0});
    joining_ = parameters.number("joining", 0.3, {0.0, 10.0});
    leaving_ = parameters.number("leaving", 0.03, {0.0, 10.0});
    prey_color_ = colorOf("prey", parameters, colors::kRed);
    colors_[kNest] = colorOf("nest", parameters, colors::kMagenta);
    refuseEqualColors(parameters, {{"prey_color", prey_color_}, {"nest_color", colors_[kNest]}});
    parameters.refuseUnread({"speed", "distance", "joining", "leaving", "prey_color", "nest_color"});
    reset();
  }

  void reset() override {
    memory_ = Memory{};
    *wheels_ = FootbotWheels{};
    enter(State::kSearch);
  }

  void step(Time, Duration dt) override {
    dt_ = toSeconds(dt);
    memory_.time_in_state += dt_;
    look();
    switch (memory_.state) {
      case State::kSearch:
        return search();
      case State::kExplore:
        return explore();
      case State::kLink:
        return link();
      case State::kReturn:
        return goBack();
      case State::kSetOut:
        return setOut();
    }
  }

  void archive(StateArchive& state) override { state(memory_); }

 private:
  enum class State { kSearch, kExplore, kLink, kReturn, kSetOut };

  /// The nest, or a link by its colour; the first and the fourth link look the same.
  using Place = std::size_t;
  static constexpr Place kNest = 0;
  static constexpr Place kPlaces = 4;
  static constexpr double kTurnRate = 1.5;   // rad/s
  static constexpr double kBendFor = 10.0;   // s, until a blocked robot tries another direction
  static constexpr double kPatience = 40.0;  // s, until it gives up and goes elsewhere

  static Place next(Place place) { return place == kPlaces - 1 ? 1 : place + 1; }
  /// @pre not the first link
  static Place before(Place link) { return link == 1 ? kPlaces - 1 : link - 1; }

  /// The visible place before this one: for a first link the nest, for a fourth one a link.
  std::optional<Sighting> previous(Place place) const {
    if (place == kNest) {
      return std::nullopt;
    }
    if (place != 1) {
      return seen_[place - 1];
    }
    const std::optional<Sighting>& link = seen_[kPlaces - 1];
    const bool is_nest_nearer = seen_[kNest] && (!link || seen_[kNest]->distance() < link->distance());
    return is_nest_nearer ? seen_[kNest] : link;
  }

  /// @throws ConfigError for a colour of the links
  Color colorOf(const std::string& thing, const Configuration& parameters, Color fallback) const {
    const std::string key = thing + "_color";
    const Color color = parameters.color(key, fallback);
    if (std::find(colors_.begin() + 1, colors_.end(), color) != colors_.end()) {
      throw ConfigError(parameters.find(key)->location(), key + ": found '" + toString(color) +
                                                              "', which links show, allowed: any other colour than " +
                                                              "blue, green and yellow");
    }
    return color;
  }

  static const char* nameOf(State state) {
    switch (state) {
      case State::kSearch:
        return "Search";
      case State::kExplore:
        return "Explore";
      case State::kLink:
        return "Link";
      case State::kReturn:
        return "Return";
      case State::kSetOut:
        return "Set Out";
    }
    return "";
  }

  void enter(State state) {
    memory_.state = state;
    memory_.time_in_state = 0.0;
    memory_.lost_for = 0.0;
    if (state == State::kExplore) {
      memory_.bend = 0.0;
      memory_.bend_left = kBendFor;
    }
    if (state == State::kSetOut) {
      memory_.turn_left = robot_->random().uniform(0.0, 2.0 * M_PI);
    }
    beacon_->color = state == State::kLink ? colors_[memory_.link] : colors::kBlack;
    robot_->debug("state", nameOf(state));
  }

  void look() {
    for (Place place = 0; place < kPlaces; ++place) {
      seen_[place] = nearestBlob(*camera_, colors_[place]);
    }
  }

  /// @return kPlaces if none is in sight
  Place nearest() const {
    Place nearest = kPlaces;
    for (Place place = 0; place < kPlaces; ++place) {
      if (seen_[place] && (nearest == kPlaces || seen_[place]->distance() < seen_[nearest]->distance())) {
        nearest = place;
      }
    }
    return nearest;
  }

  void search() {
    if (nearest() != kPlaces) {
      return enter(State::kExplore);
    }
    if (!avoidObstacle()) {
      memory_.turn_rate = wanderingTurnRate(robot_->random(), memory_.turn_rate, dt_);
      wheels_->drive(speed_, memory_.turn_rate);
    }
  }

  /// Drives along the chain while a next link is visible, and then beyond the last one.
  void explore() {
    const Place place = nearest();
    if (place == kPlaces) {
      return enter(State::kSearch);
    }
    if (memory_.time_in_state > kPatience) {
      return enter(State::kReturn);
    }
    if (const std::optional<Sighting>& next_link = seen_[next(place)]) {
      return drive(next_link->bearing());
    }
    prolong(place);
  }

  /// Drives to the place of the next link, and becomes that link at random.
  void prolong(Place end) {
    constexpr double kArrived = 0.1;       // m
    constexpr double kSharpestBend = 1.0;  // rad
    memory_.bend_left -= dt_;
    if (memory_.bend_left <= 0.0) {  // an obstacle may block that place
      memory_.bend = robot_->random().uniform(-kSharpestBend, kSharpestBend);
      memory_.bend_left = kBendFor;
    }
    const Sighting target = beyond(end);
    if (target.distance() > kArrived) {
      return drive(target.bearing());
    }
    wheels_->drive(0.0, 0.0);
    if (isByChance(joining_)) {
      memory_.link = next(end);
      memory_.is_first = end == kNest;
      enter(State::kLink);
    }
  }

  /// Place of the next link: in the direction of the chain, or in any direction from the nest.
  Sighting beyond(Place place) const {
    const Sighting& end = *seen_[place];
    const std::optional<Sighting> before = previous(place);
    const double direction =
        before ? std::atan2(end.y - before->y, end.x - before->x) + memory_.bend : std::atan2(-end.y, -end.x);
    return {end.x + distance_ * std::cos(direction), end.y + distance_ * std::sin(direction)};
  }

  /// Stands still while the link before it is visible; the last link leaves at random while it sees no prey.
  void link() {
    constexpr double kLost = 2.0;  // s: a passing robot may hide the link
    wheels_->drive(0.0, 0.0);
    const Place awaited = memory_.is_first ? kNest : before(memory_.link);
    memory_.lost_for = seen_[awaited] ? 0.0 : memory_.lost_for + dt_;
    if (memory_.lost_for > kLost) {
      return enter(State::kSearch);
    }
    const bool is_last = !seen_[next(memory_.link)] && !nearestBlob(*camera_, prey_color_);
    if (is_last && isByChance(leaving_)) {
      enter(State::kReturn);
    }
  }

  /// Drives along the chain to the nest.
  void goBack() {
    constexpr double kAtNest = 0.3;  // m
    const Place place = nearest();
    if (place == kPlaces) {
      return enter(State::kSearch);
    }
    if (memory_.time_in_state > kPatience || (seen_[kNest] && seen_[kNest]->distance() < kAtNest)) {
      return enter(State::kSetOut);
    }
    const std::optional<Sighting> target = seen_[kNest] ? seen_[kNest] : previous(place);
    drive(target ? target->bearing() : seen_[place]->bearing());
  }

  /// Drives off in a random direction.
  void setOut() {
    constexpr double kStraight = 3.0;  // s
    if (memory_.turn_left > 0.0) {
      memory_.turn_left -= kTurnRate * dt_;
      memory_.time_in_state = 0.0;
      return wheels_->drive(0.0, kTurnRate);
    }
    if (memory_.time_in_state > kStraight) {
      return enter(State::kExplore);
    }
    drive(0.0);
  }

  /// @param rate mean frequency [1/s]
  bool isByChance(double rate) { return robot_->random().uniform() < rate * dt_; }

  void drive(double bearing) {
    if (!avoidObstacle()) {
      steer(*wheels_, bearing, speed_);
    }
  }

  /// Turns away from obstacles ahead, to one side until the way is free, and drives past.
  /// @return whether the wheels were commanded
  bool avoidObstacle() {
    constexpr double kThreshold = 0.05;
    constexpr double kHalfField = 1.2;  // rad: obstacles beside and behind the robot do not count
    constexpr double kEscape = 1.0;     // s: an immediate turn back would lead to the same obstacle
    const ObstacleVector obstacle(*proximity_, kHalfField);
    if (obstacle.length() > kThreshold) {
      if (memory_.avoiding_turn == 0.0) {
        memory_.avoiding_turn = obstacle.y > 0.0 ? -kTurnRate : kTurnRate;
      }
      memory_.escape_left = kEscape;
      wheels_->drive(0.0, memory_.avoiding_turn);
      return true;
    }
    memory_.avoiding_turn = 0.0;
    if (memory_.escape_left <= 0.0) {
      return false;
    }
    memory_.escape_left -= dt_;
    wheels_->drive(speed_, 0.0);
    return true;
  }

  Robot* robot_ = nullptr;
  FootbotWheels* wheels_ = nullptr;
  FootbotBeacon* beacon_ = nullptr;
  const FootbotProximity* proximity_ = nullptr;
  const FootbotCamera* camera_ = nullptr;
  double speed_ = 0.0;     // m/s
  double distance_ = 0.0;  // m, between links
  double joining_ = 0.0;   // 1/s, rate at the end of a chain
  double leaving_ = 0.0;   // 1/s, rate of the last link
  Color prey_color_;
  std::array<Color, kPlaces> colors_{colors::kMagenta, colors::kBlue, colors::kGreen, colors::kYellow};
  double dt_ = 0.0;                                      // s
  std::array<std::optional<Sighting>, kPlaces> seen_{};  // the nearest one of each place, in this step

  /// State that a reset clears.
  struct Memory {
    State state = State::kSearch;
    double time_in_state = 0.0;  // s
    double bend = 0.0;           // rad, of the chain at its end, where this robot would extend it
    double bend_left = 0.0;      // s, until it tries another bend
    Place link = kNest;          // its place, while it is a link
    bool is_first = false;       // whether that place is beside the nest
    double lost_for = 0.0;       // s for which a link has not seen the one before it
    double turn_left = 0.0;      // rad, before it drives off
    double turn_rate = 0.0;      // rad/s, while it wanders
    double avoiding_turn = 0.0;  // rad/s, while it turns away from an obstacle
    double escape_left = 0.0;    // s of driving straight on after an obstacle
  };
  Memory memory_;
};

}  // namespace swarmanoid

REGISTER_CONTROLLER(swarmanoid::ChainFormation, "chain_formation")
