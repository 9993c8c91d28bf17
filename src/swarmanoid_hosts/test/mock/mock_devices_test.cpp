// The devices of a mock robot: their list, the generic mock, and their shared state.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "mock_bench.hpp"
#include "swarmanoid_interface/devices/differential_drive.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/proximity.hpp"

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
  static constexpr const char* kType = "manipulator_of_a_test";
  static constexpr const char* kRobot = "rover";
  double angle = 0.0;
};
template <class Visitor>
void fields(Visitor& visit, RoverArm& arm) {
  visit(arm.angle, {"angle", "rad"});
}
REGISTER_DEVICE(RoverArm, kActuator, "An arm that only rovers have.")

TEST(MockDevices, AreThoseOfTheRobotsTypeAndOthersThatAreNamed) {
  const std::vector<std::string> eyebot = devicesOf("eyebot", {}, kHere);
  for (const char* device : {"eyebot_camera", "eyebot_laser", "eyebot_leds", "eyebot_magnet", "eyebot_velocity"}) {
    EXPECT_EQ(1, std::count(eyebot.begin(), eyebot.end(), device)) << device;
  }
  for (const std::string& device : eyebot) {
    EXPECT_EQ("eyebot", findDeviceType(device)->robot) << device;
  }
  EXPECT_EQ((std::vector<std::string>{"manipulator_of_a_test", "thermometer_of_a_test"}),
            devicesOf("rover", {"thermometer_of_a_test"}, kHere));
  EXPECT_EQ((std::vector<std::string>{"fan_of_a_test"}), devicesOf("epuck", {"fan_of_a_test"}, kHere));
  EXPECT_EQ((std::vector<std::string>{"fan_of_a_test"}), devicesOf("fan", {"fan_of_a_test"}, kHere))
      << "its name begins with the type, which does not make it the type's";
  EXPECT_EQ((std::vector<std::string>{"fan_of_a_test"}), devicesOf("", {"fan_of_a_test"}, kHere))
      << "devices of any robot are not those of a robot without a type";
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
      "/m: type: found 'footboot', allowed: eyebot, footbot, handbot, rover, or any other type whose devices are named "
      "(devices); did you mean 'footbot'?",
      refusal("footboot", {}));
  EXPECT_EQ(0U, refusal("", {}).find("/m: type: found '', allowed: eyebot, ")) << refusal("", {});
  const std::string unknown = refusal("epuck", {"fan_of_a_tset"});
  EXPECT_EQ(0U, unknown.find("/m: devices: found 'fan_of_a_tset', allowed: ")) << unknown;
  EXPECT_NE(std::string::npos, unknown.find("did you mean 'fan_of_a_test'?")) << unknown;
}

/// Drivers publish visible commands: the colours of LEDs, on any robot.
TEST(MockDevices, AreShownIfPeopleSeeThem) {
  const Bench bench(std::vector<std::string>{"eyebot_leds", "footbot_leds", "footbot_wheels", "handbot_leds", "leds"});
  std::vector<std::string> shown;
  for (const MockRobot::Device& device : bench.robot->devices()) {
    if (device.mock->isShown()) {
      shown.push_back(device.type->type);
    }
  }
  EXPECT_EQ((std::vector<std::string>{"eyebot_leds", "footbot_leds", "handbot_leds", "leds"}), shown);
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

/// The effect of one device is visible to other devices in the same tick: commands, then motion, then readings.
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

/// Along an arc: with speed v and turn rate w around a point v / w to the left.
TEST(MockDifferentialDrive, MovesAnyRobotAsCommanded) {
  Bench bench(std::vector<std::string>{"differential_drive"});
  Pose start;
  start.position = {0.3, -0.2, 0.0};
  start.yaw = 0.7;
  bench.robot->place(start);
  bench.command<DifferentialDrive>().drive(0.2, 0.5);
  bench.advance(1.0);
  const Pose& pose = bench.robot->state().pose;
  EXPECT_NEAR(1.2, pose.yaw, 1e-9);
  EXPECT_NEAR(0.3 + 0.4 * (std::sin(1.2) - std::sin(0.7)), pose.position.x(), 1e-9);
  EXPECT_NEAR(-0.2 - 0.4 * (std::cos(1.2) - std::cos(0.7)), pose.position.y(), 1e-9);
  bench.robot->place(start);
  bench.command<DifferentialDrive>().drive(-2.0, 0.0);
  bench.advance(0.5);
  EXPECT_NEAR(0.3 - std::cos(0.7), pose.position.x(), 1e-9) << "backwards, as fast as it is commanded";
  EXPECT_NEAR(-0.2 - std::sin(0.7), pose.position.y(), 1e-9);
  EXPECT_NEAR(0.7, pose.yaw, 1e-12);
}

/// Five sensors on a ring of 5 cm, before a wall 8 cm ahead of where the robot would look with yaw 0: a sensor that
/// looks in direction a is 0.08 / cos(a) - 0.05 away from it.
TEST(MockProximity, FeelsAWallFromARingOfAnySize) {
  World world;
  world.ring = {5, 0.05};
  world.walls.push_back({{0.08, -1.0}, {0.08, 1.0}});
  Bench bench(std::vector<std::string>{"proximity"}, world);
  Pose start;
  start.yaw = 0.3;
  bench.robot->place(start);
  const Proximity& proximity = bench.reading<Proximity>();
  ASSERT_EQ(5U, proximity.sensors.size());
  const double angles[] = {0.0, 0.4 * M_PI, 0.8 * M_PI, -0.8 * M_PI, -0.4 * M_PI};
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(angles[i], proximity.sensors[i].angle, 1e-6) << i;
  }
  const auto closeness = [](double direction) { return 1.0 - (0.08 / std::cos(direction) - 0.05) / 0.1; };
  EXPECT_NEAR(std::pow(closeness(0.3), 3.0), proximity.sensors[0].value, 1e-6) << "0.034 m away";
  EXPECT_EQ(0.0F, proximity.sensors[1].value) << "it looks past the end of the wall";
  EXPECT_EQ(0.0F, proximity.sensors[2].value);
  EXPECT_EQ(0.0F, proximity.sensors[3].value);
  EXPECT_NEAR(std::pow(closeness(0.3 - 0.4 * M_PI), 3.0), proximity.sensors[4].value, 1e-6) << "0.089 m away";
  start.position.x() = 0.04;
  bench.robot->place(start);
  EXPECT_EQ(1.0F, proximity.sensors[0].value) << "the wall is within the ring";
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

TEST(MockWorld, HasDiscsOnItsFloor) {
  const auto worldWith = [](const std::string& radius, const std::string& color) {
    Configuration values("world", "", {"/w", 0});
    Configuration& discs = values.add(Configuration("discs", "", {"/w", 0}));
    Configuration& disc = discs.add(Configuration("nest", "", {"/w", 0}));
    disc.set("at", "0.5, -1");
    disc.set("radius", radius);
    disc.set(color, "gray");
    return readWorld(values);
  };
  const World world = worldWith("0.25", "color");
  ASSERT_EQ(1U, world.discs.size());
  EXPECT_EQ(Eigen::Vector2d(0.5, -1.0), world.discs[0].at);
  EXPECT_EQ(0.25, world.discs[0].radius);
  EXPECT_EQ(colors::kGray, world.discs[0].color);
  EXPECT_THROW(worldWith("-0.25", "color"), ConfigError);
  EXPECT_THROW(worldWith("0.25", "colour"), ConfigError);
}

TEST(MockWorld, BeaconsSayBytes) {
  const auto beaconThatSays = [](const std::string& bytes) {
    Configuration values("world", "", {"/w", 0});
    Configuration& beacon =
        values.add(Configuration("beacons", "", {"/w", 0})).add(Configuration("nest", "", {"/w", 0}));
    beacon.set("at", "1, 2, 3");
    beacon.set("color", "green");
    if (!bytes.empty()) {
      beacon.set("says", bytes);
    }
    return readWorld(values).beacons.at(0);
  };
  EXPECT_TRUE(beaconThatSays("").says.empty());
  EXPECT_EQ((std::vector<std::uint8_t>{7}), beaconThatSays("7").says);
  EXPECT_EQ((std::vector<std::uint8_t>{0, 255, 3}), beaconThatSays("0, 255,3").says);
  EXPECT_EQ(10U, beaconThatSays("1,2,3,4,5,6,7,8,9,10").says.size());
  for (const char* wrong : {"256", "-1", "1.5", "1,", ",1", "1,,2", "one", "1,2,3,4,5,6,7,8,9,10,11"}) {
    EXPECT_THROW(beaconThatSays(wrong), ConfigError) << wrong;
  }
}

TEST(MockWorld, BeaconsAnswerAndTagsLieWhereItIsSaid) {
  const auto worldWith = [](const std::string& key, const std::string& value) {
    Configuration values("world", "", {"/w", 0});
    Configuration& beacon =
        values.add(Configuration("beacons", "", {"/w", 0})).add(Configuration("nest", "", {"/w", 0}));
    beacon.set("at", "1, 2, 3");
    beacon.set("color", "green");
    beacon.set("answers", "true");
    Configuration& tag = values.add(Configuration("tags", "", {"/w", 0})).add(Configuration("door", "", {"/w", 0}));
    tag.set("at", "0.5, -1");
    tag.set("id", "7");
    tag.set(key, value);
    return readWorld(values);
  };
  const World world = worldWith("data", "4294967295");
  EXPECT_TRUE(world.beacons.at(0).answers);
  EXPECT_EQ(Eigen::Vector2d(0.5, -1.0), world.tags.at(0).at);
  EXPECT_EQ(7U, world.tags[0].id);
  EXPECT_EQ(4294967295U, world.tags[0].data);
  EXPECT_THROW(worldWith("data", "4294967296"), ConfigError);
  EXPECT_THROW(worldWith("id", "0"), ConfigError);
  EXPECT_THROW(worldWith("holds", "1"), ConfigError);
}

TEST(MockWorld, BeaconsSoundIfAskedTo) {
  Configuration values("world", "", {"/w", 0});
  Configuration& beacon = values.add(Configuration("beacons", "", {"/w", 0})).add(Configuration("horn", "", {"/w", 0}));
  beacon.set("at", "1, 2, 3");
  beacon.set("color", "green");
  EXPECT_EQ(0.0, readWorld(values).beacons.at(0).sound_level);
  beacon.set("sound_level", "62.5");
  beacon.set("sound_frequency", "441");
  EXPECT_EQ(62.5, readWorld(values).beacons.at(0).sound_level);
  EXPECT_EQ(441.0, readWorld(values).beacons.at(0).sound_frequency);
  beacon.set("sound_level", "141");
  EXPECT_THROW(readWorld(values), ConfigError);
}

TEST(MockWorld, SaysWhatRingOfSensorsARobotHas) {
  const auto ringOf = [](const std::string& sensors, const std::string& radius) {
    Configuration values("world", "", {"/w", 0});
    Configuration& ring = values.add(Configuration("ring", "", {"/w", 0}));
    ring.set("sensors", sensors);
    ring.set("radius", radius);
    return readWorld(values).ring;
  };
  EXPECT_EQ(8U, readWorld(Configuration("world", "", {"/w", 0})).ring.sensors) << "the usual ones";
  EXPECT_EQ(64U, ringOf("64", "0.07").sensors);
  EXPECT_EQ(0.07, ringOf("64", "0.07").radius);
  EXPECT_THROW(ringOf("0", "0.07"), ConfigError);
  EXPECT_THROW(ringOf("65", "0.07"), ConfigError);
  EXPECT_THROW(ringOf("5", "-0.01"), ConfigError);
  Configuration values("world", "", {"/w", 0});
  values.add(Configuration("ring", "", {"/w", 0})).set("sensors", "3");
  const auto robot = makeMockRobot({Proximity::kType}, values);
  EXPECT_EQ(3U, static_cast<const Proximity*>(robot->devices()[0].value.get())->sensors.size());
  values.set("rings", "2");
  std::string refusal;
  try {
    makeMockRobot({Proximity::kType}, values);
  } catch (const ConfigError& error) {
    refusal = error.what();
  }
  EXPECT_NE(std::string::npos, refusal.find("did you mean 'ring'?")) << refusal;
}

TEST(MockWorld, SaysHowManyJointsAndHoldersARobotHas) {
  const auto worldOf = [](const std::string& parts, const std::string& name, const std::string& value) {
    Configuration values("world", "", {"/w", 0});
    values.add(Configuration(parts, "", {"/w", 0})).set(name, value);
    return readWorld(values);
  };
  EXPECT_EQ(1U, readWorld(Configuration("world", "", {"/w", 0})).joints.count) << "the usual one";
  EXPECT_EQ(16U, worldOf("joints", "count", "16").joints.count);
  EXPECT_EQ(0.5, worldOf("joints", "fastest", "0.5").joints.fastest);
  EXPECT_EQ(8U, worldOf("holders", "count", "8").holders.count);
  EXPECT_EQ(2.5, worldOf("holders", "rope", "2.5").holders.rope);
  EXPECT_THROW(worldOf("joints", "count", "17"), ConfigError);
  EXPECT_THROW(worldOf("joints", "count", "0"), ConfigError);
  EXPECT_THROW(worldOf("holders", "count", "9"), ConfigError);
  EXPECT_THROW(worldOf("holders", "rope", "-1"), ConfigError);
  EXPECT_THROW(worldOf("joints", "names", "3"), ConfigError);
}

}  // namespace
}  // namespace swarmanoid::mock
