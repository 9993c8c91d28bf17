// Wheels, gripper and LEDs: their commands after limits, noise and checks.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "device_world.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/leds.hpp"

namespace swarmanoid::test {
namespace {

using Wheels = ActuatorUnderTest<FootbotWheels>;
using Leds = ActuatorUnderTest<FootbotLeds>;

constexpr double kMaxSpeed = 10.344827586206895;  // rad/s: 0.3 m/s
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(FootbotWheelsTest, PassesWhatTheMotorsCanDoAndLimitsTheRestWheelByWheel) {
  DeviceWorld world;
  const Row robot = world.addFootbot(1.0, 1.0);
  Wheels wheels(world, robot);
  for (const auto& [command, expected] :
       {std::pair(0.0, 0.0), std::pair(3.7, 3.7), std::pair(-3.7, -3.7), std::pair(kMaxSpeed, kMaxSpeed),
        std::pair(kMaxSpeed + 1e-9, kMaxSpeed), std::pair(-1e300, -kMaxSpeed),
        std::pair(std::numeric_limits<double>::max(), kMaxSpeed)}) {
    wheels.command.setAngularVelocity(command, 1.0);
    EXPECT_EQ(wheels.actuate().left, expected);
    EXPECT_EQ(wheels.actuate().right, 1.0);
    wheels.command.setAngularVelocity(1.0, command);
    EXPECT_EQ(wheels.actuate().right, expected);
    EXPECT_EQ(wheels.actuate().left, 1.0);
    EXPECT_TRUE(wheels.faulty.empty());
  }
}

TEST(FootbotWheelsTest, ANumberThatIsNoneStandsStillAndIsReported) {
  for (const double bad : {kNan, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()}) {
    DeviceWorld world;
    const Row robot = world.addFootbot(1.0, 1.0);
    Wheels wheels(world, robot, {{"noise", "0.5"}});
    wheels.command.setAngularVelocity(2.0, bad);
    EXPECT_EQ(wheels.actuate().left, 0.0);
    EXPECT_EQ(wheels.actuate().right, 0.0);
    EXPECT_EQ(wheels.faulty, std::vector<Row>{robot});
  }
}

TEST(FootbotWheelsTest, CommandsStayUntilTheyAreChangedAndStopForgetsThem) {
  DeviceWorld world;
  const Row robot = world.addFootbot(1.0, 1.0);
  Wheels wheels(world, robot);
  wheels.command.setAngularVelocity(2.0, 3.0);
  wheels.actuate();
  EXPECT_EQ(wheels.actuate().right, 3.0);
  EXPECT_TRUE(wheels.stop());
  EXPECT_EQ(world.space.actuation.find<FootbotWheels>(robot)->right, 0.0) << "in the same tick";
  EXPECT_EQ(wheels.actuate().right, 0.0);
}

std::vector<double> lefts(std::uint64_t seed, const std::string& noise, double speed, int ticks = 5000) {
  DeviceWorld world(seed);
  Wheels wheels(world, world.addFootbot(1.0, 1.0), {{"noise", noise}});
  wheels.command.setAngularVelocity(speed, speed);
  std::vector<double> result;
  double product = 0.0;
  for (int i = 0; i < ticks; ++i, ++world.space.tick) {
    const FootbotWheels& actuation = wheels.actuate();
    product += (actuation.left - speed) * (actuation.right - speed);
    result.push_back(actuation.left);
  }
  // the noise of the two wheels is independent
  const double deviation = std::stod(noise) * speed;
  EXPECT_NEAR(product / ticks, 0.0, 5.0 * deviation * deviation / std::sqrt(ticks) + 1e-12);
  return result;
}

TEST(FootbotWheelsTest, NoiseIsAFactorWithTheStatedDeviation) {
  const Statistics statistics(lefts(1, "0.1", 2.0));
  EXPECT_NEAR(statistics.mean, 2.0, 5.0 * 0.2 / std::sqrt(5000.0));
  EXPECT_NEAR(statistics.deviation, 0.2, 5.0 * 0.2 / std::sqrt(2.0 * 5000.0));
  for (const double standing : lefts(1, "0.1", 0.0)) {
    EXPECT_EQ(standing, 0.0);
  }
  for (const double fast : lefts(1, "0.5", kMaxSpeed, 500)) {
    EXPECT_LE(fast, kMaxSpeed);
  }
}

TEST(FootbotWheelsTest, NoiseBelongsToTheSeed) {
  EXPECT_EQ(lefts(1, "0.1", 2.0, 50), lefts(1, "0.1", 2.0, 50));
  EXPECT_NE(lefts(1, "0.1", 2.0, 50), lefts(2, "0.1", 2.0, 50));
  EXPECT_EQ(lefts(1, "0", 2.0, 50), std::vector<double>(50, 2.0));
}

TEST(FootbotGripperTest, TheCommandPassesAndTheSwitchSaysWhatIsHeld) {
  DeviceWorld world;
  const Row robot = world.addFootbot(1.0, 1.0);
  const Row other = world.addFootbot(2.0, 1.0);
  const Row prey = world.addPrey(1.2, 1.0);
  ActuatorUnderTest<FootbotGripper> gripper(world, robot);
  SensorUnderTest<FootbotGripperState> state(world, robot);
  EXPECT_FALSE(gripper.actuate().closed);
  gripper.command.close();
  EXPECT_TRUE(gripper.actuate().closed);
  EXPECT_FALSE(state.sense().gripping) << "closed, but on nothing";
  world.space.structure.connect(robot, prey);
  EXPECT_TRUE(state.sense().gripping);
  world.space.structure.release(robot);
  world.space.structure.connect(other, robot);
  EXPECT_FALSE(state.sense().gripping) << "being gripped is not gripping";
}

TEST(FootbotLedsTest, EachLedShowsItsColourAndOthersAreLeftAlone) {
  DeviceWorld world;
  const Row other = world.addFootbot(2.0, 1.0);
  const Row robot = world.addFootbot(1.0, 1.0);
  const Span<Color> others = world.space.leds[other];
  std::fill(others.begin(), others.end(), colors::kWhite);
  Leds leds(world, robot);
  for (std::size_t i = 0; i < FootbotLeds::kCount; ++i) {
    leds.command.ring[i] = {static_cast<std::uint8_t>(i), 1, 2};
  }
  leds.actuate();
  const Span<const Color> shown = world.space.leds[robot];
  ASSERT_EQ(shown.size(), FootbotLeds::kCount);
  for (std::size_t i = 0; i < FootbotLeds::kCount; ++i) {
    EXPECT_EQ(shown[i], (Color{static_cast<std::uint8_t>(i), 1, 2})) << "LED " << i;
    EXPECT_EQ(others[i], colors::kWhite);
  }
}

TEST(FootbotLedsTest, AStoppedRobotKeepsItsLights) {
  DeviceWorld world;
  const Row robot = world.addFootbot(1.0, 1.0);
  Leds leds(world, robot);
  leds.command.setAll(colors::kRed);
  leds.actuate();
  EXPECT_TRUE(leds.stop());
  for (std::size_t i = 0; i < FootbotLeds::kCount; ++i) {
    EXPECT_EQ(world.space.leds[robot][i], colors::kRed);
  }
}

TEST(EyebotLedsTest, ItsRingHasSixteen) {
  DeviceWorld world;
  const Row robot = world.addEyebot(1.0, 1.0, 2.0);
  ActuatorUnderTest<EyebotLeds> leds(world, robot);
  leds.command.setAll(colors::kCyan);
  leds.actuate();
  const Span<const Color> shown = world.space.leds[robot];
  EXPECT_EQ(shown.size(), 16U);
  EXPECT_EQ(std::count(shown.begin(), shown.end(), colors::kCyan), 16);
}

}  // namespace
}  // namespace swarmanoid::test
