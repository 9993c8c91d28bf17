// Flocking by range and bearing, after Turgut, Celikkanat, Gokce and Sahin, "Self-organized flocking in mobile robot
// swarms", Swarm Intelligence 2 (2008): each footbot aligns with the headings that its neighbours say, and keeps its
// distance from them. All headings are against a lamp far away, which stands for the compass of the paper's robots.
#include <cstdint>
#include <optional>

#include "blob_search.hpp"
#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/range_and_bearing.hpp"

namespace swarmanoid {

class Flocking final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    wheels_ = &robot.actuator<FootbotWheels>();
    transmitter_ = &robot.actuator<RangeAndBearing>();
    received_ = &robot.sensor<RangeAndBearingReceived>();
    camera_ = &robot.sensor<FootbotCamera>();
    speed_ = parameters.number("speed", 0.1, {0.0, 0.3});
    distance_ = parameters.number("distance", 0.5, {0.1, 10.0});
    cohesion_ = parameters.number("cohesion", 0.5, {0.0, 100.0});
    aligns_ = parameters.boolean("alignment", true);
    compass_color_ = parameters.color("compass_color", colors::kWhite);
    parameters.refuseUnread({"speed", "distance", "cohesion", "alignment", "compass_color"});
    reset();
  }

  void reset() override {
    *wheels_ = FootbotWheels{};
    transmitter_->fallSilent();
  }

  void step(Time, Duration) override {
    const std::optional<double> heading = look();
    if (heading) {
      transmitter_->send(payloadOf(*heading));
    } else {
      transmitter_->fallSilent();
    }
    const Eigen::Vector2d ahead = Eigen::Vector2d::UnitX();
    const Eigen::Vector2d course = (heading && aligns_ ? alignment(*heading) : ahead) + cohesion_ * proximity();
    drive(course);
  }

 private:
  static constexpr double kTurnGain = 1.0;         // 1/s
  static constexpr double kStepsOfTurn = 65536.0;  // that the two bytes of a message tell apart

  /// @return the robot's heading against the direction of the lamp [rad]; nothing if it is not in sight
  std::optional<double> look() const {
    const std::optional<Sighting> lamp = nearestBlob(*camera_, compass_color_);
    return lamp ? std::optional<double>(-lamp->bearing()) : std::nullopt;
  }

  static RangeAndBearing::Payload payloadOf(double heading) {
    // an unsigned number of 16 bits goes round as an angle does
    const auto steps = static_cast<std::uint16_t>(std::llround(heading / (2.0 * M_PI) * kStepsOfTurn));
    RangeAndBearing::Payload payload{};
    payload[0] = static_cast<std::uint8_t>(steps >> 8U);
    payload[1] = static_cast<std::uint8_t>(steps & 0xFFU);
    return payload;
  }

  static double headingIn(const RangeAndBearing::Payload& payload) {
    return (256.0 * payload[0] + payload[1]) / kStepsOfTurn * 2.0 * M_PI;
  }

  /// The mean direction of the headings of all neighbours, of length 1; ahead if it hears none.
  Eigen::Vector2d alignment(double own_heading) const {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const RangeAndBearingMessage& message : received_->messages) {
      const double relative = headingIn(message.payload) - own_heading;
      sum += Eigen::Vector2d(std::cos(relative), std::sin(relative));
    }
    return sum.isZero() ? Eigen::Vector2d::UnitX().eval() : sum.normalized();
  }

  /// Away from neighbours that are nearer than the wanted distance, towards those that are farther away: a force of the
  /// Lennard-Jones kind, 1 where it attracts most, which is at 1.29 times that distance.
  Eigen::Vector2d proximity() const {
    constexpr double kStrongest = 0.1859;  // of s^3 (1 - s^2), where s^2 = 3 / 5
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const RangeAndBearingMessage& message : received_->messages) {
      const double s = distance_ / static_cast<double>(message.range);
      const double pull = s * s * s * (1.0 - s * s) / kStrongest;
      const auto bearing = static_cast<double>(message.bearing);
      sum += pull * Eigen::Vector2d(std::cos(bearing), std::sin(bearing));
    }
    return sum;
  }

  /// Turns towards the course, and drives as far as it lies ahead.
  void drive(const Eigen::Vector2d& course) {
    const double bearing = course.isZero() ? 0.0 : std::atan2(course.y(), course.x());
    wheels_->drive(speed_ * std::max(0.0, std::cos(bearing)), kTurnGain * bearing);
  }

  FootbotWheels* wheels_ = nullptr;
  RangeAndBearing* transmitter_ = nullptr;
  const RangeAndBearingReceived* received_ = nullptr;
  const FootbotCamera* camera_ = nullptr;
  double speed_ = 0.0;     // m/s
  double distance_ = 0.0;  // m, between neighbours
  double cohesion_ = 0.0;  // weight of the force between neighbours, against that of the alignment
  bool aligns_ = true;
  Color compass_color_;  // of the lamp against which headings are
};

}  // namespace swarmanoid

REGISTER_CONTROLLER(swarmanoid::Flocking, "flocking")
