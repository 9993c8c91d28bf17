// The eyebot's position controller, with odometry: it adds up the distances and turns of its actual flight.
#include "swarmanoid_interface/devices/eyebot_position.hpp"

#include <algorithm>
#include <cmath>

#include "common/mechanisms.hpp"
#include "common/parameters.hpp"
#include "common/tick_guard.hpp"
#include "eyebot_pilot.hpp"
#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_space/actuator.hpp"

namespace swarmanoid::devices {
namespace {

struct PositionInstance : BasicActuatorInstance<EyebotPosition> {
  EyebotPilot before;  // state at the start of the last computed tick
  EyebotPilot pilot;   // after the command of that tick
  Pose pose;           // of the robot at the start of that tick
  TickGuard tick;

  void archive(StateArchive& state) { state(before, pilot, pose, tick); }
};

class EyebotPositionActuator final : public ActuatorOf<EyebotPosition, PositionInstance> {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = EyebotPosition::kType;
    description.implementation = "default";
    description.is_default = true;
    description.mechanisms = {flight()};
    description.summary =
        "A place in the frame of the take-off, to which it flies with limited speed and acceleration.";
    description.parameters = {number("max_speed", "m/s", numberText(EyebotPosition::kUsualFastest), {0.01, 5.0},
                                     "The longest velocity that is flown."),
                              number("max_acceleration", "m/s2", numberText(EyebotPosition::kUsualAcceleration),
                                     {0.1, 10.0}, "The longest change of the velocity."),
                              number("max_yaw_rate", "rad/s", numberText(EyebotPosition::kUsualFastestTurn),
                                     {0.0, 10.0}, "The fastest turn."),
                              number("landing_speed", "m/s", numberText(EyebotPosition::kUsualSinking), {0.01, 5.0},
                                     "How fast it sinks when it lands.")};
    return description;
  }

  void configure(const Configuration& parameters) override {
    limits_.speed = parameters.number("max_speed", EyebotPosition::kUsualFastest);
    limits_.acceleration = parameters.number("max_acceleration", EyebotPosition::kUsualAcceleration);
    limits_.yaw_rate = parameters.number("max_yaw_rate", EyebotPosition::kUsualFastestTurn);
    limits_.sinking = parameters.number("landing_speed", EyebotPosition::kUsualSinking);
  }

 protected:
  void limit(const Space& /*space*/, PositionInstance& instance) override {
    constexpr double kFarthest = EyebotPosition::kFarthest;
    Eigen::Vector3d& position = instance.actuation->position;
    position = position.cwiseMax(-kFarthest).cwiseMin(kFarthest);
  }

  void apply(const Space& space, const ActuateAccess& access, PositionInstance& instance) override {
    const bool is_added = !instance.tick.hasBegun();
    const bool is_new = instance.tick.begins(space.tick);
    if (is_added) {
      instance.pose = space.entities.pose[instance.row];
      access.flight[instance.row] = {true, Eigen::Vector3d::Zero(), 0.0};
      return;
    }
    const double dt = toSeconds(space.clocktick);
    if (is_new) {
      instance.before = instance.pilot;
      measure(space, dt, instance);
    }
    instance.pilot = instance.before;
    const EyebotPilot::Flight flight = instance.pilot.fly(*instance.actuation, limits_, dt);
    access.flight[instance.row] = {true, flight.linear, flight.yaw_rate};
  }

 private:
  static double headingOf(const Pose& pose) {
    const Eigen::Vector3d ahead = pose.orientation * Eigen::Vector3d::UnitX();
    return std::atan2(ahead.y(), ahead.x());
  }

  static void measure(const Space& space, double dt, PositionInstance& instance) {
    const Pose& pose = space.entities.pose[instance.row];
    const double heading = headingOf(pose);
    const Eigen::AngleAxisd to_heading(-heading, Eigen::Vector3d::UnitZ());
    if (space.placed[instance.row] == space.tick) {
      instance.before.moved(Eigen::Vector3d::Zero(), 0.0, dt);  // a teleport is not flown
    } else {
      instance.before.moved(to_heading * (pose.position - instance.pose.position),
                            wrapAngle(heading - headingOf(instance.pose)), dt);
    }
    instance.pose = pose;
  }

  EyebotPilot::Limits limits_;
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::EyebotPositionActuator)
