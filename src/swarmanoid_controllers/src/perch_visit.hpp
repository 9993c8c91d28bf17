/// How a footbot charges its battery: at a low charge it looks for a perch that shows that it is free, and stands
/// beside it until the battery is full. Its LEDs shine while it stands there, and other robots keep away from that
/// perch. A robot whose battery ran empty beside a perch stays there until it is full.
#pragma once

#include <algorithm>

#include "blob_search.hpp"
#include "distinct_colors.hpp"
#include "obstacle_escape.hpp"
#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/devices/battery.hpp"
#include "swarmanoid_interface/devices/leds.hpp"

namespace swarmanoid {

class PerchVisit {
 public:
  /// Defaults of the colour parameters.
  struct Colors {
    Color free;
    Color taken;
    Color charging;  ///< of the robot's LEDs beside a perch
  };

  /// @param speed of the robot [m/s]
  void init(Robot& robot, const Configuration& parameters, double speed, const Colors& usual) {
    robot_ = &robot;
    wheels_ = &robot.actuator<FootbotWheels>();
    leds_ = &robot.actuator<FootbotLeds>();
    proximity_ = &robot.sensor<FootbotProximity>();
    camera_ = &robot.sensor<FootbotCamera>();
    battery_ = &robot.sensor<Battery>();
    speed_ = speed;
    little_ = parameters.number("little", 0.6, {0.0, 1.0});
    plenty_ = parameters.number("plenty", 0.98, {0.0, 1.0});
    free_color_ = parameters.color("free_color", usual.free);
    taken_color_ = parameters.color("taken_color", usual.taken);
    charging_color_ = parameters.color("charging_color", usual.charging);
  }

  /// Colours that must differ from each other and from all others that the robot recognizes (distinct_colors.hpp). @pre
  /// init
  std::vector<NamedColor> colors() const {
    return {{"free_color", free_color_}, {"taken_color", taken_color_}, {"charging_color", charging_color_}};
  }

  void reset() { memory_ = Memory{}; }
  void archive(StateArchive& state) { state(memory_); }

  /// Called at the start of each step. The first call checks whether the robot already stands beside a perch that
  /// charges it.
  void update(double dt) {
    dt_ = dt;
    if (memory_.has_looked) {
      return;
    }
    memory_.has_looked = true;
    chooseLimit();
    const std::optional<Sighting> perch = nearestUnattended(taken_color_);
    if (perch && perch->distance() < kTaken) {
      enter(State::kCharge);
    }
  }

  /// Whether the charge is low enough to begin a visit.
  bool isDue() const { return battery_->fraction() < memory_.limit; }
  void begin() { enter(State::kSeek); }
  bool isUnderWay() const { return memory_.state != State::kNone; }

  /// Drives the robot during a visit, which ends when the battery is full.
  void step() { memory_.state == State::kSeek ? seek() : charge(); }

 private:
  enum class State { kNone, kSeek, kCharge };

  static constexpr double kBeside = 0.26;  // m from the perch: within its reach, but its post is not an obstacle yet
  static constexpr double kTaken = 0.36;   // m: the reach of a perch plus the error of the camera

  void enter(State state) {
    memory_.state = state;
    memory_.escape.reset();
    memory_.time_unserved = 0.0;
    leds_->setAll(state == State::kCharge ? charging_color_ : colors::kBlack);
    if (state != State::kNone) {
      robot_->debug("state", state == State::kSeek ? "Seek Perch" : "Charge");
    }
  }

  /// The limit is random so that robots with equal charge do not all come at once.
  void chooseLimit() { memory_.limit = robot_->random().uniform(0.7, 1.0) * little_; }

  void seek() {
    const std::optional<Sighting> perch = nearestUnattended(free_color_);
    const std::optional<Sighting> taken = nearestUnattended(taken_color_);
    const bool has_arrived = perch && perch->distance() < kBeside;
    if (has_arrived || (taken && taken->distance() < kTaken)) {  // or the perch began to charge the robot on its way
      return enter(State::kCharge);
    }
    if (!perch) {
      return waitForPerch();
    }
    if (!isAvoiding()) {
      steer(*wheels_, perch->bearing(), speed_);
    }
  }

  /// Standing still saves energy, and the distance keeps the way free for other robots.
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

  /// A charging perch shows the colour of a taken one; otherwise it is empty, or charges no robot.
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
      enter(State::kNone);
    }
  }

  /// The nearest perch of a colour without another robot's charging light beside it.
  std::optional<Sighting> nearestUnattended(Color color) const {
    constexpr double kAttended = 0.45;  // m from a robot's LED to the perch
    std::optional<Sighting> nearest;
    for (const ColorBlob& blob : camera_->blobs) {
      const Sighting perch = sightingOf(blob);
      if (blob.color != color || (nearest && perch.distance() >= nearest->distance())) {
        continue;
      }
      const bool is_attended =
          std::any_of(camera_->blobs.begin(), camera_->blobs.end(), [this, &perch](const ColorBlob& other) {
            return other.color == charging_color_ && sightingOf(other).distanceTo(perch) < kAttended;
          });
      if (!is_attended) {
        nearest = perch;
      }
    }
    return nearest;
  }

  bool isAvoiding() { return memory_.escape.drive(*wheels_, *proximity_, robot_->random(), speed_, dt_); }

  Robot* robot_ = nullptr;
  FootbotWheels* wheels_ = nullptr;
  FootbotLeds* leds_ = nullptr;
  const FootbotProximity* proximity_ = nullptr;
  const FootbotCamera* camera_ = nullptr;
  const Battery* battery_ = nullptr;
  double speed_ = 0.0;   // m/s
  double little_ = 0.0;  // maximum charge at which the robot looks for a perch, as a part of the capacity
  double plenty_ = 0.0;  // charge at which it leaves, as a part of the capacity
  Color free_color_;
  Color taken_color_;
  Color charging_color_;
  double dt_ = 0.0;  // s

  /// State that is kept between steps.
  struct Memory {
    State state = State::kNone;
    bool has_looked = false;  // the first step is over
    double limit = 0.0;       // charge below which the robot looks for a perch, as a part of the capacity
    ObstacleEscape escape;
    double time_unserved = 0.0;  // s beside a perch that does not show the colour of a taken one
  };
  Memory memory_;
};

}  // namespace swarmanoid
