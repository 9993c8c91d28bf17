// An eyebot that recognizes two places by their colours: it flies to and fro between them, and its LEDs show that it
// lays a trail below, for footbots, which have a shorter view. It stays where it is while its goal is not in sight.
#include <array>

#include "blob_search.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"
#include "swarmanoid_interface/devices/leds.hpp"

namespace swarmanoid {

class Scout final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    robot_ = &robot;
    velocity_ = &robot.actuator<EyebotVelocity>();
    leds_ = &robot.actuator<EyebotLeds>();
    camera_ = &robot.sensor<EyebotCamera>();
    speed_ = parameters.number("speed", 0.2, {0.01, 1.0});
    there_ = parameters.number("there", 0.25, {0.01, 10.0});
    goals_ = {parameters.color("first", colors::kYellow), parameters.color("second", colors::kCyan)};
    color_ = parameters.color("color", colors::kMagenta);
    parameters.refuseUnread({"speed", "there", "first", "second", "color"});
    reset();
  }

  void reset() override {
    *velocity_ = EyebotVelocity{};
    leds_->setAll(colors::kBlack);
    turnTo(0);
  }

  void step(Time, Duration) override {
    velocity_->linear.setZero();
    const std::optional<Sighting> goal = nearestBlob(*camera_, goals_[goal_]);
    leds_->setAll(goal ? color_ : colors::kBlack);
    if (!goal) {
      return;
    }
    if (goal->distance() < there_) {
      return turnTo(1 - goal_);
    }
    velocity_->linear.x() = speed_ * std::cos(goal->bearing());
    velocity_->linear.y() = speed_ * std::sin(goal->bearing());
  }

  void archive(StateArchive& state) override { state(goal_); }

 private:
  void turnTo(std::size_t goal) {
    goal_ = goal;
    robot_->debug("state", goal == 0 ? "To the First" : "To the Second");
  }

  Robot* robot_ = nullptr;
  EyebotVelocity* velocity_ = nullptr;
  EyebotLeds* leds_ = nullptr;
  const EyebotCamera* camera_ = nullptr;
  double speed_ = 0.0;  // m/s
  double there_ = 0.0;  // m, distance from the middle of a patch at which it is reached
  std::array<Color, 2> goals_;
  Color color_;
  std::size_t goal_ = 0;  // index; a reset clears it
};

}  // namespace swarmanoid

REGISTER_CONTROLLER(swarmanoid::Scout, "scout")
