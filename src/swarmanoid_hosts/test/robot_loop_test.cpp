// Tests a robot's loop with a clock that the test advances.
#include "swarmanoid_hosts/robot_loop.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "swarmanoid_interface/devices/eyebot_magnet.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"

namespace swarmanoid {
namespace {

using std::chrono::milliseconds;
constexpr Duration kPeriod = milliseconds(100);

/// The input that the controller received, and the actions that it is to take.
struct Script {
  std::vector<double> seen;   // readings of sensor 0
  std::vector<double> times;  // [s]
  std::vector<double> dts;    // [s]
  int destroyed = 0;
  int reset = 0;
  bool is_to_throw = false;
  double speed = 2.0;
};

/// Drives ahead, up if it can fly, and grips.
class Scripted final : public Controller {
 public:
  explicit Scripted(Script& script) : script_(script) {}
  void init(Robot& robot, const Configuration&) override {
    robot_ = &robot;
    proximity_ = robot.hasSensor(FootbotProximity::kType) ? &robot.sensor<FootbotProximity>() : nullptr;
    wheels_ = robot.hasActuator(FootbotWheels::kType) ? &robot.actuator<FootbotWheels>() : nullptr;
    gripper_ = robot.hasActuator(FootbotGripper::kType) ? &robot.actuator<FootbotGripper>() : nullptr;
    velocity_ = robot.hasActuator(EyebotVelocity::kType) ? &robot.actuator<EyebotVelocity>() : nullptr;
  }
  void step(Time time, Duration dt) override {
    script_.times.push_back(toSeconds(time - kEpoch));
    script_.dts.push_back(toSeconds(dt));
    if (proximity_ != nullptr) {
      script_.seen.push_back(static_cast<double>(proximity_->value[0]));
    }
    if (wheels_ != nullptr) {
      wheels_->setAngularVelocity(script_.speed, script_.speed);
    }
    if (gripper_ != nullptr) {
      gripper_->close();
    }
    if (velocity_ != nullptr) {
      velocity_->linear = {0.0, 0.0, 1.0};
    }
    robot_->debug("state", "driving");
    if (script_.is_to_throw) {
      throw std::runtime_error("told to");
    }
  }
  void reset() override { ++script_.reset; }
  void destroy() override { ++script_.destroyed; }

 private:
  Script& script_;
  Robot* robot_ = nullptr;
  const FootbotProximity* proximity_ = nullptr;
  FootbotWheels* wheels_ = nullptr;
  FootbotGripper* gripper_ = nullptr;
  EyebotVelocity* velocity_ = nullptr;
};

RobotConfiguration footbot() {
  RobotConfiguration configuration;
  configuration.robot_type = "footbot";
  configuration.period = kPeriod;
  configuration.sensors = {{FootbotProximity::kType, "proximity"}};
  configuration.actuators = {{FootbotWheels::kType, "wheels/command"}, {FootbotGripper::kType, "gripper/command"}};
  configuration.sensor_timeout = milliseconds(500);
  configuration.start_timeout = milliseconds(2000);
  return configuration;
}

/// A robot whose devices are connected as long as `are_there` is true.
struct Bench {
  explicit Bench(RobotConfiguration configuration = footbot()) {
    loop = std::make_unique<RobotLoop>(
        "fb_1", "scripted", std::move(configuration), [this] { return std::make_shared<Scripted>(script); }, nullptr,
        now);
  }
  /// @return whether commands are to be sent, for the last tick
  bool tick(int count = 1, std::uint64_t passed = 1) {
    bool is_to_send = false;
    for (int i = 0; i < count; ++i) {
      now += static_cast<Duration::rep>(passed) * kPeriod;
      if (are_there) {
        hear();
      }
      is_to_send = loop->tick(now, passed);
    }
    return is_to_send;
  }
  void hear() {
    for (RobotLoop::Sensor& sensor : loop->sensors()) {
      sensor.heard = now;
    }
    for (RobotLoop::Actuator& actuator : loop->actuators()) {
      actuator.is_heard = true;
    }
  }
  template <class Device>
  Device command() const {
    for (const RobotLoop::Actuator& actuator : loop->actuators()) {
      if (actuator.device.type == Device::kType) {
        return *static_cast<const Device*>(actuator.command.data.get());
      }
    }
    throw std::logic_error("no such actuator");
  }

  Script script;
  Duration now = std::chrono::seconds(1000);
  bool are_there = true;
  std::unique_ptr<RobotLoop> loop;
};

using State = RobotLoop::State;
using End = RobotLoop::End;

TEST(RobotLoop, RunsOnceAllDevicesAreThere) {
  Bench bench;
  bench.are_there = false;
  EXPECT_FALSE(bench.tick());
  EXPECT_EQ(State::kWaiting, bench.loop->state());
  EXPECT_EQ(
      "waiting for footbot_proximity (nobody publishes proximity); footbot_wheels (nobody subscribes to "
      "wheels/command); footbot_gripper (nobody subscribes to gripper/command)",
      bench.loop->text());
  bench.loop->sensors()[0].heard = bench.now;
  bench.loop->actuators()[0].is_heard = true;
  EXPECT_FALSE(bench.tick());
  EXPECT_EQ("waiting for footbot_gripper (nobody subscribes to gripper/command)", bench.loop->text());
  EXPECT_TRUE(bench.script.times.empty());
  bench.are_there = true;
  static_cast<FootbotProximity*>(bench.loop->sensors()[0].reading.data.get())->value[0] = 0.25F;
  EXPECT_TRUE(bench.tick());
  EXPECT_EQ(State::kRunning, bench.loop->state());
  EXPECT_EQ(2.0, bench.command<FootbotWheels>().left);
  EXPECT_TRUE(bench.command<FootbotGripper>().closed);
  EXPECT_EQ(std::vector<double>{0.25}, bench.script.seen);
  EXPECT_EQ((std::vector<Robot::DebugValue>{{"state", "driving"}}), bench.loop->debugValues());
}

TEST(RobotLoop, NamesWhatIsMissingAndDoesNotStart) {
  Bench bench;
  bench.are_there = false;
  bench.loop->actuators()[0].is_heard = true;
  bench.loop->actuators()[1].is_heard = true;
  bench.tick(19);
  EXPECT_EQ(State::kWaiting, bench.loop->state());
  EXPECT_FALSE(bench.tick());
  EXPECT_EQ(State::kOver, bench.loop->state());
  EXPECT_EQ(End::kMissing, bench.loop->whyItEnds());
  EXPECT_EQ("missing: footbot_proximity (nobody publishes proximity)", bench.loop->text());
  bench.are_there = true;
  EXPECT_FALSE(bench.tick());
  EXPECT_TRUE(bench.script.times.empty());
}

TEST(RobotLoop, ASensorThatFellSilentBeforeTheStartIsMissing) {
  Bench bench;
  bench.are_there = false;
  bench.hear();
  bench.loop->actuators()[0].is_heard = false;
  bench.tick(6);
  bench.loop->actuators()[0].is_heard = true;
  EXPECT_FALSE(bench.tick());
  EXPECT_EQ("waiting for footbot_proximity (nobody publishes proximity)", bench.loop->text());
}

TEST(RobotLoop, TimeGoesByWholePeriodsMissedOnesIncluded) {
  Bench bench;
  bench.tick(2);
  bench.tick(1, 3);
  bench.tick();
  const std::vector<double> times{0.0, 0.1, 0.4, 0.5};
  const std::vector<double> dts{0.1, 0.1, 0.3, 0.1};
  ASSERT_EQ(4U, bench.script.times.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    EXPECT_NEAR(times[i], bench.script.times[i], 1e-12);
    EXPECT_NEAR(dts[i], bench.script.dts[i], 1e-12);
  }
  EXPECT_EQ(5U, bench.loop->sensorFrame().stamp.tick);
  EXPECT_EQ(bench.loop->sensorFrame().stamp, bench.loop->commandFrame().stamp);
}

TEST(RobotLoop, StopsWhenSensorsAreLostAndGoesOnWhenTheyAreBack) {
  Bench bench;
  bench.tick(3);
  bench.are_there = false;
  bench.tick(5);
  EXPECT_EQ(State::kRunning, bench.loop->state()) << "the time-out is 0.5 s";
  EXPECT_TRUE(bench.tick());
  EXPECT_EQ(State::kStopped, bench.loop->state());
  EXPECT_EQ("stopped safely: footbot_proximity (proximity) is silent for 0.60 s", bench.loop->text());
  EXPECT_EQ(0.0, bench.command<FootbotWheels>().left);
  EXPECT_TRUE(bench.command<FootbotGripper>().closed) << "what is held is not dropped";
  EXPECT_FALSE(bench.loop->hasStepped());
  EXPECT_TRUE(bench.tick(20)) << "drivers get commands all the time";
  EXPECT_EQ(8U, bench.loop->steps());
  bench.are_there = true;
  EXPECT_TRUE(bench.tick());
  EXPECT_EQ(State::kRunning, bench.loop->state());
  EXPECT_EQ(2.0, bench.command<FootbotWheels>().left);
  EXPECT_NEAR(0.8, bench.script.times.back(), 1e-12) << "its time stood still";
  EXPECT_NEAR(0.1, bench.script.dts.back(), 1e-12);
  EXPECT_EQ(0, bench.script.reset);
  EXPECT_EQ(1U, bench.loop->stops());
}

TEST(RobotLoop, StopsInTheVeryPeriodOfAnExceptionAndNeverGoesOn) {
  Bench bench;
  bench.tick(3);
  bench.script.is_to_throw = true;
  EXPECT_TRUE(bench.tick());
  EXPECT_EQ(State::kEnding, bench.loop->state());
  EXPECT_EQ(0.0, bench.command<FootbotWheels>().left);
  EXPECT_EQ("the controller failed: told to", bench.loop->text());
  EXPECT_TRUE(bench.loop->hasStepped()) << "the failure is to be recorded";
  bench.script.is_to_throw = false;
  EXPECT_TRUE(bench.tick(2));
  EXPECT_EQ(State::kOver, bench.loop->state());
  EXPECT_EQ(End::kFailed, bench.loop->whyItEnds());
  EXPECT_EQ(4U, bench.script.times.size());
  EXPECT_FALSE(bench.tick());
}

TEST(RobotLoop, ACommandThatIsNotFiniteIsAFailure) {
  Bench bench;
  bench.tick();
  bench.script.speed = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(bench.tick());
  EXPECT_EQ("the controller failed: footbot_wheels: found a number that is not finite", bench.loop->text());
  EXPECT_EQ(0.0, bench.command<FootbotWheels>().right);
}

TEST(RobotLoop, EndsSafely) {
  Bench bench;
  bench.tick(2);
  bench.loop->end(bench.now);
  EXPECT_TRUE(bench.tick());
  EXPECT_EQ(State::kEnding, bench.loop->state());
  EXPECT_EQ(0.0, bench.command<FootbotWheels>().left);
  EXPECT_TRUE(bench.tick(2));
  EXPECT_EQ(State::kOver, bench.loop->state());
  EXPECT_EQ(End::kAsked, bench.loop->whyItEnds());
  EXPECT_EQ(0, bench.script.destroyed);
  bench.loop.reset();
  EXPECT_EQ(1, bench.script.destroyed);
}

TEST(RobotLoop, EndsAtOnceWhereNothingWasCommanded) {
  Bench bench;
  bench.are_there = false;
  bench.tick(2);
  bench.loop->end(bench.now);
  EXPECT_EQ(State::kOver, bench.loop->state());
  EXPECT_FALSE(bench.tick());
}

TEST(RobotLoop, AnEyebotComesDownBeforeItIsOver) {
  RobotConfiguration configuration = footbot();
  configuration.robot_type = "eyebot";
  configuration.sensors = {{EyebotMagnetState::kType, "magnet/state"}};
  configuration.actuators = {{EyebotVelocity::kType, "cmd_vel"}};
  configuration.safe_stop = {0.5, 0.4, 1.0};
  Bench bench(configuration);
  bench.tick();
  EXPECT_EQ(1.0, bench.command<EyebotVelocity>().linear.z());
  bench.loop->end(bench.now);
  double way = 0.0;  // [m]
  int periods = 0;
  while (bench.loop->state() != State::kOver && periods < 100) {
    EXPECT_TRUE(bench.tick());
    way += bench.command<EyebotVelocity>().linear.z() * toSeconds(kPeriod);
    ++periods;
  }
  EXPECT_NEAR(-0.4, way, 1e-9);
  EXPECT_EQ(15, periods);
  EXPECT_EQ(0.0, bench.command<EyebotVelocity>().linear.z());
}

TEST(RobotLoop, AStopUnderWayIsNotBegunAgainAtTheEnd) {
  RobotConfiguration configuration = footbot();
  configuration.robot_type = "eyebot";
  configuration.sensors = {{EyebotMagnetState::kType, "magnet/state"}};
  configuration.actuators = {{EyebotVelocity::kType, "cmd_vel"}};
  configuration.safe_stop = {0.5, 0.4, 1.0};
  Bench bench(configuration);
  bench.tick();
  bench.are_there = false;
  bench.tick(6 + 7);
  EXPECT_EQ(State::kStopped, bench.loop->state());
  EXPECT_EQ(-0.4, bench.command<EyebotVelocity>().linear.z());
  bench.loop->end(bench.now);
  bench.tick();
  EXPECT_EQ(-0.4, bench.command<EyebotVelocity>().linear.z());
}

struct NoFields {
  static constexpr const char* kType = "no_fields";
};

TEST(RobotLoop, RefusesADeviceWithoutFields) {
  RobotConfiguration configuration = footbot();
  configuration.sensors.push_back({NoFields::kType, "x"});
  EXPECT_THROW(Bench{configuration}, std::runtime_error);
}

}  // namespace
}  // namespace swarmanoid
