// Pattern formation by artificial physics, after Spears, Spears, Hamann and Heil, "Distributed, physics-based control
// of swarms of vehicles", Autonomous Robots 17 (2004): forces between neighbours, limited to less than the distance of
// the second row of a hexagonal grid, arrange robots on such a grid. Here the force is of the Lennard-Jones kind. A
// prey, which the camera sees from farther away, acts as one more grid point, and the robots gather around it.
#include <algorithm>
#include <cmath>

#include "blob_search.hpp"
#include "lennard_jones.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/range_and_bearing.hpp"

namespace swarmanoid {

class Predators final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    wheels_ = &robot.actuator<FootbotWheels>();
    transmitter_ = &robot.actuator<RangeAndBearing>();
    received_ = &robot.sensor<RangeAndBearingReceived>();
    camera_ = &robot.sensor<FootbotCamera>();
    speed_ = parameters.number("speed", 0.1, {0.0, 0.3});
    distance_ = parameters.number("distance", 0.4, {0.1, 10.0});
    appetite_ = parameters.number("appetite", 0.05, {0.0, 10.0});
    prey_color_ = parameters.color("prey_color", colors::kRed);
    parameters.refuseUnread({"speed", "distance", "appetite", "prey_color"});
    reset();
  }

  void reset() override {
    *wheels_ = FootbotWheels{};
    transmitter_->fallSilent();
  }

  void step(Time, Duration) override {
    transmitter_->send({});  // an empty message: neighbours measure its range and bearing
    drive(planarForceOfNeighbours(*received_, distance_, kReach * distance_) + forceOfPrey());
  }

  void archive(StateArchive& /*state*/) override {}

 private:
  /// As a multiple of the distance: between the first row of neighbours, at 1, and the second, at sqrt(3).
  static constexpr double kReach = 1.5;

  static Eigen::Vector2d towards(double bearing) { return {std::cos(bearing), std::sin(bearing)}; }

  /// Repels like a neighbour; attracts less than a neighbour, but from any distance at which it is visible.
  Eigen::Vector2d forceOfPrey() const {
    const std::optional<Sighting> prey = nearestBlob(*camera_, prey_color_);
    if (!prey) {
      return Eigen::Vector2d::Zero();
    }
    const double force = lennardJones(std::min(prey->distance(), kStrongestRange * distance_), distance_);
    return (force > 0.0 ? appetite_ * force : force) * towards(prey->bearing());
  }

  /// Drives along the force, ahead or backwards, while turning towards it; below kFull the speed is proportional to it.
  void drive(const Eigen::Vector2d& force) {
    constexpr double kFull = 0.5;      // force from which on the speed is maximal
    constexpr double kTurnGain = 1.5;  // 1/s
    const double strength = std::min(1.0, force.norm() / kFull);
    double bearing = force.isZero() ? 0.0 : std::atan2(force.y(), force.x());
    const double way = std::abs(bearing) > M_PI / 2.0 ? -1.0 : 1.0;
    bearing -= way < 0.0 ? std::copysign(M_PI, bearing) : 0.0;
    wheels_->drive(way * speed_ * strength * std::cos(bearing), kTurnGain * strength * bearing);
  }

  FootbotWheels* wheels_ = nullptr;
  RangeAndBearing* transmitter_ = nullptr;
  const RangeAndBearingReceived* received_ = nullptr;
  const FootbotCamera* camera_ = nullptr;
  double speed_ = 0.0;     // m/s
  double distance_ = 0.0;  // m, between neighbours, and to the prey
  double appetite_ = 0.0;  // attraction of the prey as a part of the force between neighbours
  Color prey_color_;
};

}  // namespace swarmanoid

REGISTER_CONTROLLER(swarmanoid::Predators, "predators")
