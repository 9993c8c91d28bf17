// Aggregation without computation: Gauci, Chen, Li, Dodd and Gross, "Self-organized aggregation without computation",
// International Journal of Robotics Research 33 (2014). The controller is memoryless. Its only input is one bit,
// whether another robot is on the line ahead, and it has two movements: with the default wheel speeds it turns on the
// spot if the bit is set, and drives backwards on a circle otherwise. All robots show the colour that they look for;
// with black, which no camera detects, the bit is always 0.
#include <cmath>

#include "blob_search.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/leds.hpp"

namespace swarmanoid {

class Aggregation final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    robot_ = &robot;
    wheels_ = &robot.actuator<FootbotWheels>();
    leds_ = &robot.actuator<FootbotLeds>();
    camera_ = &robot.sensor<FootbotCamera>();
    speed_ = parameters.number("speed", 0.15, {0.01, 0.3});
    color_ = parameters.color("color", colors::kGreen);
    turn_ = {parameters.number("turn_left", kTurn.left, kPart), parameters.number("turn_right", kTurn.right, kPart)};
    circle_ = {parameters.number("circle_left", kCircle.left, kPart),
               parameters.number("circle_right", kCircle.right, kPart)};
    parameters.refuseUnread({"speed", "color", "turn_left", "turn_right", "circle_left", "circle_right"});
    reset();
  }

  void reset() override {
    leds_->setAll(color_);
    *wheels_ = FootbotWheels{};
    robot_->debug("state", "Circle");
  }

  void step(Time, Duration) override {
    const bool sees = seesRobotAhead();
    const Wheels& part = sees ? turn_ : circle_;
    wheels_->left = part.left * speed_ / FootbotWheels::kRadius;
    wheels_->right = part.right * speed_ / FootbotWheels::kRadius;
    robot_->debug("state", sees ? "Turn" : "Circle");
  }

  void archive(StateArchive& /*state*/) override {}

 private:
  /// Wheel speeds as parts of the maximum.
  struct Wheels {
    double left = 0.0;
    double right = 0.0;
  };
  static constexpr Wheels kTurn{1.0, -1.0};     // the paper's best controller
  static constexpr Wheels kCircle{-0.7, -1.0};  // the paper's, too: a circle of 0.4 m with a footbot's wheels
  static constexpr Range kPart{-1.0, 1.0};
  /// Half the width of the line [m]. LEDs are 44 mm apart, so a line through a robot hits one of them.
  static constexpr double kHalfWidth = 0.025;

  bool seesRobotAhead() const {
    for (const ColorBlob& blob : camera_->blobs) {
      const Sighting led = sightingOf(blob);
      if (blob.color == color_ && led.x > 0.0 && std::abs(led.y) <= kHalfWidth) {
        return true;
      }
    }
    return false;
  }

  Robot* robot_ = nullptr;
  FootbotWheels* wheels_ = nullptr;
  FootbotLeds* leds_ = nullptr;
  const FootbotCamera* camera_ = nullptr;
  double speed_ = 0.0;  // m/s, of the faster wheel
  Wheels turn_;         // while it sees another robot
  Wheels circle_;       // while it sees no robot
  Color color_;
};

}  // namespace swarmanoid

REGISTER_CONTROLLER(swarmanoid::Aggregation, "aggregation")
