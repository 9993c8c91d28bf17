// Emergent taxis: phototaxis of a swarm that results from obstacle avoidance alone, by the omega algorithm of Bjerknes
// and Winfield, "On fault tolerance and scalability of swarm robotic systems", DARS 2010. No robot measures the
// direction of the light. Lit robots keep a greater distance from others than shadowed ones, and a robot without an
// encounter for some time turns towards the others. The swarm therefore stays together, and moves slowly towards the
// light.
#include <algorithm>
#include <cmath>

#include "differential_drive.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/light.hpp"
#include "swarmanoid_interface/devices/range_and_bearing.hpp"

namespace swarmanoid {

class EmergentTaxis final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    robot_ = &robot;
    wheels_ = &robot.actuator<FootbotWheels>();
    messages_ = &robot.actuator<RangeAndBearing>();
    light_ = &robot.sensor<Light>();
    others_ = &robot.sensor<RangeAndBearingReceived>();
    speed_ = parameters.number("speed", 0.15, {0.01, 0.3});
    omega_ = parameters.number("omega", 5.0, {0.1, 1000.0});
    radius_in_light_ = parameters.number("radius_in_light", 0.5, {0.17, 3.0});
    radius_in_shadow_ = parameters.number("radius_in_shadow", 0.35, {0.17, 3.0});
    parameters.refuseUnread({"speed", "omega", "radius_in_light", "radius_in_shadow"});
    reset();
  }

  void reset() override {
    memory_ = Memory{};
    messages_->sends = true;  // an empty message: others measure its range and bearing
    *wheels_ = FootbotWheels{};
    robot_->debug("state", "Go Ahead");
  }

  void step(Time, Duration dt) override {
    const double seconds = toSeconds(dt);
    memory_.alone_for += seconds;
    const Others others = look(isInLight() ? radius_in_light_ : radius_in_shadow_);
    if (others.are_near) {
      memory_ = Memory{};
      steer(*wheels_, std::atan2(others.away.y(), others.away.x()), speed_);
      robot_->debug("state", "Avoid");
    } else if (memory_.turn_left != 0.0) {
      const double turn = std::clamp(memory_.turn_left, -kTurnRate * seconds, kTurnRate * seconds);
      memory_.turn_left -= turn;
      wheels_->drive(0.0, turn / seconds);
    } else if (memory_.alone_for > omega_ && !others_->messages.empty()) {
      memory_ = Memory{};
      memory_.turn_left = std::atan2(others.middle.y(), others.middle.x());
      robot_->debug("state", "Turn Back");
    } else {
      wheels_->drive(speed_, 0.0);
      robot_->debug("state", "Go Ahead");
    }
  }

  void archive(StateArchive& state) override { state(memory_); }

 private:
  static constexpr double kTurnRate = 1.5;   // rad/s
  static constexpr float kDark = 0.01F;      // a reading of a light sensor
  static constexpr std::size_t kAround = 4;  // half of the sensors face the light, and half of those must be lit

  /// State that an encounter clears.
  struct Memory {
    double alone_for = 0.0;  // s since the robot last avoided another one or turned back
    double turn_left = 0.0;  // rad towards the others, counter-clockwise
  };

  /// Directions of the other robots, in the robot's frame.
  struct Others {
    bool are_near = false;
    Eigen::Vector2d away = Eigen::Vector2d::Zero();    // from those that are too near, weighted by nearness
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();  // sum of the positions of all visible ones [m]
  };

  bool isInLight() const {
    std::size_t lit = 0;
    for (const LightReading& sensor : light_->sensors) {
      lit += sensor.value > kDark ? 1 : 0;
    }
    return lit * kAround >= light_->sensors.size();
  }

  /// @param radius below which a distance is too small [m]
  Others look(double radius) const {
    Others others;
    for (const RangeAndBearingMessage& message : others_->messages) {
      const double bearing = static_cast<double>(message.bearing);
      const double range = static_cast<double>(message.range);
      const Eigen::Vector2d direction(std::cos(bearing), std::sin(bearing));
      others.middle += range * direction;
      if (range < radius) {
        others.are_near = true;
        others.away -= (radius - range) * direction;
      }
    }
    return others;
  }

  Robot* robot_ = nullptr;
  FootbotWheels* wheels_ = nullptr;
  RangeAndBearing* messages_ = nullptr;
  const Light* light_ = nullptr;
  const RangeAndBearingReceived* others_ = nullptr;
  double speed_ = 0.0;             // m/s
  double omega_ = 0.0;             // s
  double radius_in_light_ = 0.0;   // m, avoidance distance between the robots' centres
  double radius_in_shadow_ = 0.0;  // m, the same in shadow
  Memory memory_;
};

}  // namespace swarmanoid

REGISTER_CONTROLLER(swarmanoid::EmergentTaxis, "emergent_taxis")
