// Which devices a mock robot has, what those without a mock of their own do, and what they share.
#include <gtest/gtest.h>

#include <cmath>

#include "mock_bench.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"

namespace swarmanoid::mock {
namespace {

/// Devices that have no mock of their own.
struct Thermometer {
  static constexpr const char* kType = "thermometer_of_a_test";
  double temperature = 20.5;
};
template <class Visitor>
void fields(Visitor& visit, Thermometer& thermometer) {
  visit(thermometer.temperature, {"temperature", "degC"});
}
REGISTER_DEVICE(Thermometer, kSensor, "How warm it is.")

struct Fan {
  static constexpr const char* kType = "fan_of_a_test";
  double speed = 0.0;
};
template <class Visitor>
void fields(Visitor& visit, Fan& fan) {
  visit(fan.speed, {"speed", "rad/s"});
}
REGISTER_DEVICE(Fan, kActuator, "Makes wind.")

struct RoverArm {
  static constexpr const char* kType = "rover_arm";
  double angle = 0.0;
};
template <class Visitor>
void fields(Visitor& visit, RoverArm& arm) {
  visit(arm.angle, {"angle", "rad"});
}
REGISTER_DEVICE(RoverArm, kActuator, "Belongs to a rover by its name.")

TEST(MockDevices, AreThoseOfTheRobotsTypeAndOthersThatAreNamed) {
  EXPECT_EQ((std::vector<std::string>{"eyebot_camera", "eyebot_laser", "eyebot_leds", "eyebot_magnet",
                                      "eyebot_magnet_state", "eyebot_velocity"}),
            devicesOf("eyebot", {}, kHere));
  EXPECT_EQ((std::vector<std::string>{"rover_arm", "thermometer_of_a_test"}),
            devicesOf("rover", {"thermometer_of_a_test"}, kHere));
  EXPECT_EQ((std::vector<std::string>{"fan_of_a_test"}), devicesOf("epuck", {"fan_of_a_test"}, kHere));
}

TEST(MockDevices, ThatAreNotKnownAreRefused) {
  const auto refusal = [](const std::string& type, const std::vector<std::string>& others) -> std::string {
    try {
      devicesOf(type, others, kHere);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(
      "/m: type: found 'footboot', allowed: eyebot, footbot, handbot, or any other type whose devices are named "
      "(devices); did you mean 'footbot'?",
      refusal("footboot", {}));
  const std::string unknown = refusal("epuck", {"fan_of_a_tset"});
  EXPECT_EQ(0U, unknown.find("/m: devices: found 'fan_of_a_tset', allowed: differential_drive, ")) << unknown;
  EXPECT_NE(std::string::npos, unknown.find("did you mean 'fan_of_a_test'?")) << unknown;
}

TEST(MockDevices, OfTheRobotsAreNotGeneric) {
  for (const DeviceType* type : deviceTypes()) {
    EXPECT_TRUE(type->robot.empty() || findMockDevice(type->type) != nullptr) << type->type;
  }
}

TEST(MockDevices, WithoutAMockOfTheirOwnRestAndStop) {
  Bench bench(std::vector<std::string>{"thermometer_of_a_test", "fan_of_a_test", "footbot_wheels"});
  CommandWatchdog watchdog(*bench.robot, 0.5);
  EXPECT_EQ(20.5, bench.reading<Thermometer>().temperature) << "its resting value";
  bench.command<Fan>().speed = 7.0;
  watchdog.commanded(bench.indexOf<Fan>());
  bench.advance(1.0);
  EXPECT_EQ(20.5, bench.reading<Thermometer>().temperature);
  EXPECT_EQ(7.0, bench.command<Fan>().speed);
  EXPECT_EQ(0.0, bench.robot->state().pose.position.norm()) << "no effect";
  watchdog.advance(0.6);
  EXPECT_EQ(0.0, bench.command<Fan>().speed) << "the safe stop";
}

/// What one device does, another device of the same tick sees: commands, then motion, then readings.
TEST(MockDevices, ActThenTheRobotMovesThenTheySense) {
  Bench bench(std::vector<std::string>{"footbot_proximity", "footbot_wheels"}, [] {
    World world;
    world.walls.push_back({{0.2, -1.0}, {0.2, 1.0}});
    return world;
  }());
  EXPECT_EQ(0.0F, bench.reading<FootbotProximity>().value[0]) << "0.115 m away";
  bench.command<FootbotWheels>().drive(0.3, 0.0);
  bench.robot->advance(0.2);
  EXPECT_NEAR(std::pow(0.45, 3.0), bench.reading<FootbotProximity>().value[0], 1e-6) << "0.055 m away";
}

TEST(MockDriversWatchdog, StopsWhatHasHadNoCommandForTooLong) {
  Bench bench("footbot");
  CommandWatchdog watchdog(*bench.robot, 0.5);
  const std::size_t wheels = bench.indexOf<FootbotWheels>();
  const auto advance = [&](double seconds) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds / kStep)); ++i) {
      watchdog.advance(kStep);
      bench.robot->advance(kStep);
    }
  };
  bench.command<FootbotWheels>().drive(0.1, 0.0);
  bench.command<FootbotGripper>().close();
  watchdog.commanded(wheels);
  advance(0.4);
  watchdog.commanded(wheels);
  advance(0.4);
  EXPECT_NEAR(0.08, bench.robot->state().pose.position.x(), 1e-9);
  advance(1.0);
  EXPECT_TRUE(watchdog.hasExpired(wheels));
  EXPECT_FALSE(watchdog.hasExpired(bench.indexOf<FootbotGripper>())) << "it never had a command";
  EXPECT_EQ(0.0, bench.command<FootbotWheels>().left);
  EXPECT_TRUE(bench.command<FootbotGripper>().closed);
  EXPECT_NEAR(0.09, bench.robot->state().pose.position.x(), 0.0021);
}

TEST(MockWorld, IsReadFromParametersAndRefusesOthers) {
  Configuration values("world", "", {"/w", 0});
  Configuration& walls = values.add(Configuration("walls", "", {"/w", 0}));
  walls.set("front", "1, -1, 1, 1");
  EXPECT_NEAR(1.0, distanceToWall(readWorld(values), {0.0, 0.0}, 0.0), 1e-12);
  EXPECT_NEAR(std::sqrt(1.25), distanceToWall(readWorld(values), {0.0, 0.0}, std::atan(0.5)), 1e-12);
  EXPECT_TRUE(std::isinf(distanceToWall(readWorld(values), {0.0, 0.0}, M_PI)));
  EXPECT_TRUE(std::isinf(distanceToWall(readWorld(values), {0.0, 2.0}, 0.0)));
  values.set("start", "0.3, 0.2, 0");
  const auto robot = makeMockRobot({FootbotProximity::kType}, values);
  EXPECT_EQ(0.2, robot->state().pose.position.y());
  values.set("ceilin", "2");
  EXPECT_THROW(makeMockRobot({FootbotProximity::kType}, values), ConfigError);
}

}  // namespace
}  // namespace swarmanoid::mock
