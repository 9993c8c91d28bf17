// Flocking by range and bearing, after Turgut, Celikkanat, Gokce and Sahin, "Self-organized flocking in mobile robot
// swarms", Swarm Intelligence 2 (2008): each footbot aligns with the headings that its neighbours send, and keeps its
// distance from them. Headings are relative to a distant lamp, which replaces the compass of the paper's robots.
#include <optional>

#include "blob_search.hpp"
#include "heading_messages.hpp"
#include "lennard_jones.hpp"
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
      transmitter_->send(payloadOfHeading(*heading));
    } else {
      transmitter_->fallSilent();
    }
    const Eigen::Vector2d ahead = Eigen::Vector2d::UnitX();
    const Eigen::Vector2d course = (heading && aligns_ ? alignment(*received_, *heading) : ahead) +
                                   cohesion_ * planarForceOfNeighbours(*received_, distance_);
    drive(course);
  }

  void archive(StateArchive& /*state*/) override {}

 private:
  static constexpr double kTurnGain = 1.0;  // 1/s

  /// @return the robot's heading relative to the direction of the lamp [rad]; nothing if the lamp is not in sight
  std::optional<double> look() const {
    const std::optional<Sighting> lamp = nearestBlob(*camera_, compass_color_);
    return lamp ? std::optional<double>(-lamp->bearing()) : std::nullopt;
  }

  /// Turns towards the course, at a speed proportional to its forward component.
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
  double cohesion_ = 0.0;  // weight of the force between neighbours relative to the alignment
  bool aligns_ = true;
  Color compass_color_;  // of the lamp that defines the reference heading
};

}  // namespace swarmanoid

REGISTER_CONTROLLER(swarmanoid::Flocking, "flocking")
