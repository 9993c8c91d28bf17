// Flocking of eyebots in three dimensions: the flock of footbots (flocking.cpp) with the range and bearing board of
// flying robots, after Roberts, Stirling, Zufferey and Floreano, "3-D relative positioning sensor for indoor flying
// robots", Autonomous Robots 33 (2012), which measures elevation too. Each eyebot aligns with the compass headings that
// its neighbours send, and keeps its distance from them in all directions.
#include <algorithm>
#include <cmath>

#include "heading_messages.hpp"
#include "lennard_jones.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"
#include "swarmanoid_interface/devices/positioning.hpp"
#include "swarmanoid_interface/devices/range_and_bearing.hpp"

namespace swarmanoid {

class EyebotFlocking final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    flight_ = &robot.actuator<EyebotVelocity>();
    transmitter_ = &robot.actuator<RangeAndBearing>();
    received_ = &robot.sensor<RangeAndBearingReceived>();
    tracker_ = &robot.sensor<Positioning>();
    speed_ = parameters.number("speed", 0.3, {0.0, 1.0});
    distance_ = parameters.number("distance", 1.5, {0.6, 10.0});
    cohesion_ = parameters.number("cohesion", 0.2, {0.0, 100.0});
    aligns_ = parameters.boolean("alignment", true);
    lowest_ = parameters.number("lowest", 2.0, {0.5, 100.0});
    parameters.refuseUnread({"speed", "distance", "cohesion", "alignment", "lowest"});
    reset();
  }

  void reset() override {
    *flight_ = EyebotVelocity{};
    transmitter_->fallSilent();
  }

  void step(Time, Duration) override {
    transmitter_->send(payloadOfHeading(tracker_->heading));
    const Eigen::Vector3d force = cohesion_ * forceOfNeighbours();
    flight_->linear = speed_ * (Eigen::Vector3d::UnitX() + force);
    flight_->linear.z() += climb();
    const Eigen::Vector2d course = alignment(*received_, tracker_->heading);
    flight_->yaw_rate = aligns_ ? kTurnGain * std::atan2(course.y(), course.x()) : 0.0;
  }

  void archive(StateArchive& /*state*/) override {}

 private:
  static constexpr double kTurnGain = 1.0;   // 1/s
  static constexpr double kClimbGain = 1.0;  // 1/s

  Eigen::Vector3d forceOfNeighbours() const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const RangeAndBearingMessage& message : received_->messages) {
      const auto bearing = static_cast<double>(message.bearing);
      const auto elevation = static_cast<double>(message.elevation);
      const Eigen::Vector3d direction(std::cos(elevation) * std::cos(bearing), std::cos(elevation) * std::sin(bearing),
                                      std::sin(elevation));
      sum += lennardJones(static_cast<double>(message.range), distance_) * direction;
    }
    return sum;
  }

  /// Upward speed, proportional to the distance below the minimum height [m/s]. The altitude sensor would not do: it
  /// measures the distance to the object straight below, which may be another eyebot.
  double climb() const { return kClimbGain * std::max(0.0, lowest_ - tracker_->position.z()); }

  EyebotVelocity* flight_ = nullptr;
  RangeAndBearing* transmitter_ = nullptr;
  const RangeAndBearingReceived* received_ = nullptr;
  const Positioning* tracker_ = nullptr;  // compass and barometer
  double speed_ = 0.0;                    // m/s
  double distance_ = 0.0;                 // m, between neighbours
  double cohesion_ = 0.0;                 // weight of the force between neighbours relative to the alignment
  bool aligns_ = true;
  double lowest_ = 0.0;  // m, minimum height
};

}  // namespace swarmanoid

REGISTER_CONTROLLER(swarmanoid::EyebotFlocking, "eyebot_flocking")
