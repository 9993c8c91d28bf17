// A controller that is a probabilistic finite state machine of simple behaviours: AutoMoDe (machine.hpp). The building
// blocks are the six behaviours and six conditions of its paper; the machine is set by parameters of the experiment
// file. It runs on footbots, and on any robot with a differential drive, proximity sensors and the sensors that its
// machine needs: light sensors, ground sensors, range and bearing.
#include <algorithm>

#include "../differential_drive.hpp"
#include "machine.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/ground.hpp"
#include "swarmanoid_interface/devices/light.hpp"
#include "swarmanoid_interface/devices/range_and_bearing.hpp"

namespace swarmanoid {

class BehaviourMachine final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    robot_ = &robot;
    base_ = MobileBase(robot);
    machine_ = Machine(parameters);
    speed_ = parameters.number("speed", 0.15, {0.0, 0.3});
    threshold_ = parameters.number("threshold", 0.1, {0.0, 10.0});
    parameters.refuseUnread({"states", "transitions", "speed", "threshold"});
    findSensors(robot);
    reset();
  }

  void reset() override {
    machine_.reset();
    turn_steps_ = 0;
    base_.drive(0.0, 0.0);
    if (transmitter_ != nullptr) {
      transmitter_->fallSilent();
    }
    robot_->debug("state", machine_.state().name);
  }

  void step(Time, Duration) override {
    if (transmitter_ != nullptr) {
      transmitter_->send({});  // an empty message: neighbours measure its range and bearing
    }
    if (machine_.advance({shade(), received_ == nullptr ? 0 : received_->messages.size()}, robot_->random())) {
      turn_steps_ = 0;
    }
    robot_->debug("state", machine_.state().name);
    act(machine_.state());
  }

  void archive(StateArchive& state) override { state(machine_, turn_steps_, turn_rate_); }

 private:
  static Eigen::Vector2d towards(double bearing) { return {std::cos(bearing), std::sin(bearing)}; }

  /// Requires only the devices that the machine uses. @throws DeviceError
  void findSensors(Robot& robot) {
    if (machine_.uses(Behaviour::kPhototaxis) || machine_.uses(Behaviour::kAntiPhototaxis)) {
      light_ = &robot.sensor<Light>();
    }
    if (machine_.uses(Condition::kBlackFloor) || machine_.uses(Condition::kGrayFloor) ||
        machine_.uses(Condition::kWhiteFloor)) {
      ground_ = &robot.sensor<Ground>();
    }
    if (machine_.uses(Behaviour::kAttraction) || machine_.uses(Behaviour::kRepulsion) ||
        machine_.uses(Condition::kManyNeighbours) || machine_.uses(Condition::kFewNeighbours)) {
      transmitter_ = &robot.actuator<RangeAndBearing>();
      received_ = &robot.sensor<RangeAndBearingReceived>();
    }
  }

  void act(const MachineState& state) {
    switch (state.behaviour) {
      case Behaviour::kExploration:
        return explore(state.turning);
      case Behaviour::kStop:
        return base_.drive(0.0, 0.0);
      case Behaviour::kPhototaxis:
        return avoidOnTheWay(lightVector());
      case Behaviour::kAntiPhototaxis:
        return avoidOnTheWay(-lightVector());
      case Behaviour::kAttraction:
        return avoidOnTheWay(state.strength * neighbourVector());
      case Behaviour::kRepulsion:
        return avoidOnTheWay(-state.strength * neighbourVector());
    }
  }

  /// Drives straight on; at an obstacle ahead it turns on the spot, away from it, for a random number of steps.
  void explore(int turning) {
    constexpr double kHalfField = 1.0;  // rad, of obstacles ahead
    constexpr double kTurnRate = 1.5;   // rad/s
    const ObstacleVector obstacle = base_.obstacles(kHalfField);
    if (turn_steps_ == 0 && obstacle.length() > threshold_) {
      turn_steps_ = 1 + static_cast<int>(robot_->random().below(static_cast<std::uint64_t>(turning)));
      turn_rate_ = obstacle.y > 0.0 ? -kTurnRate : kTurnRate;
    }
    if (turn_steps_ > 0) {
      --turn_steps_;
      return base_.drive(0.0, turn_rate_);
    }
    base_.drive(speed_, 0.0);
  }

  /// Steers along `wanted` (straight ahead if it is zero) minus five times the obstacle vector.
  void avoidOnTheWay(const Eigen::Vector2d& wanted) {
    constexpr double kAvoidance = 5.0;
    const ObstacleVector obstacle = base_.obstacles(M_PI);
    const Eigen::Vector2d aim = wanted.isZero() ? Eigen::Vector2d::UnitX().eval() : wanted;
    const Eigen::Vector2d course = aim - kAvoidance * Eigen::Vector2d(obstacle.x, obstacle.y);
    steer(base_, course.isZero() ? 0.0 : std::atan2(course.y(), course.x()), speed_);
  }

  /// Unit vector towards the light; zero in the dark.
  Eigen::Vector2d lightVector() const {
    constexpr double kDark = 1e-4;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const LightReading& sensor : light_->sensors) {
      sum += static_cast<double>(sensor.value) * towards(static_cast<double>(sensor.angle));
    }
    return sum.norm() < kDark ? Eigen::Vector2d::Zero().eval() : sum.normalized();
  }

  /// Vector towards the neighbours, weighted by nearness.
  Eigen::Vector2d neighbourVector() const {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const RangeAndBearingMessage& message : received_->messages) {
      sum += towards(static_cast<double>(message.bearing)) / (1.0 + static_cast<double>(message.range));
    }
    return sum;
  }

  /// The shade that more than half of the ground sensors read; gray if there is no such majority.
  FloorShade shade() const {
    if (ground_ == nullptr) {
      return FloorShade::kGray;
    }
    constexpr float kBlack = 0.25F;
    constexpr float kWhite = 0.75F;
    const auto& spots = ground_->sensors;
    const auto black =
        std::count_if(spots.begin(), spots.end(), [](const GroundSpot& spot) { return spot.value < kBlack; });
    const auto white =
        std::count_if(spots.begin(), spots.end(), [](const GroundSpot& spot) { return spot.value > kWhite; });
    const auto half = static_cast<std::ptrdiff_t>(spots.size() / 2);
    return black > half ? FloorShade::kBlack : white > half ? FloorShade::kWhite : FloorShade::kGray;
  }

  Robot* robot_ = nullptr;
  MobileBase base_;
  // sensors that the machine does not need, and then the transmitter, stay null
  const Light* light_ = nullptr;
  const Ground* ground_ = nullptr;
  RangeAndBearing* transmitter_ = nullptr;
  const RangeAndBearingReceived* received_ = nullptr;
  Machine machine_;
  double speed_ = 0.0;      // m/s
  double threshold_ = 0.0;  // length of the obstacle vector above which an exploration turns
  int turn_steps_ = 0;      // remaining steps of the turn
  double turn_rate_ = 0.0;  // rad/s, of that turn
};

}  // namespace swarmanoid

REGISTER_CONTROLLER(swarmanoid::BehaviourMachine, "behaviour_machine")
