// Batteries of robots: drawn power, robots that are off, and the super-capacitor. A footbot in these tests draws 3.2 W
// for its electronics, 0.3 W for its gripper, 0.24 W for its infrared sensors: 3.74 W; and 4 W more with both wheels at
// their limit of 10.3448 rad/s.
#include <gtest/gtest.h>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/leds.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

class TestLights final : public Controller {
 public:
  void init(Robot& robot, const Configuration&) override {
    auto& leds = robot.actuator<FootbotLeds>();
    leds.ring[0] = colors::kWhite;
    leds.ring[5] = colors::kRed;
    leds.ring[7] = Color{51, 51, 51};
  }
  void step(Time, Duration) override {}
};

/// Fails in its second start, or in its first step.
class TestFailing final : public Controller {
 public:
  static inline int starts = 0;
  static inline bool fails_in_step = false;

  void init(Robot&, const Configuration&) override {
    if (++starts == 2) {
      throw std::runtime_error("twice");
    }
  }
  void step(Time, Duration) override {
    if (fails_in_step) {
      throw std::runtime_error("in a step");
    }
  }
};

constexpr double kStandby = 3.74;                              // W
constexpr double kPerWheel = 4.0 / 2.0 / (0.3 / 0.029);        // W per rad/s
constexpr double kDriving = kStandby + 2.0 * 2.0 * kPerWheel;  // W, at 2 rad/s: 4.513333
constexpr const char* kStill = "<left>0</left><right>0</right>";
constexpr const char* kAhead = "<left>2</left><right>2</right>";  // 0.058 m/s

/// @param battery elements of the robot "fb"
World worldWith(const std::string& battery, const std::string& drive) {
  World world;
  world.entities = footbot("fb", 5, 5, 0);
  world.entities.insert(world.entities.find("</footbot>"), battery);
  world.members = member("fb");
  world.drive = drive;
  world.ticks = 10000;
  return world;
}

std::string battery(double capacity, double capacitor, double level = 1.0) {
  return "<battery>true</battery><battery_capacity>" + numberText(capacity) + "</battery_capacity><battery_capacitor>" +
         numberText(capacitor) + "</battery_capacitor><battery_level>" + numberText(level) + "</battery_level>";
}

std::unique_ptr<Simulation> started(const std::string& battery, const std::string& drive) {
  auto simulation = worldWith(battery, drive).make();
  simulation->start();
  return simulation;
}

/// @param controller instead of "test_drive", without parameters
std::unique_ptr<Simulation> startedWith(const std::string& controller, const std::string& battery) {
  const std::string usual = "test_drive";
  std::string text = worldWith(battery, "").xml();
  for (std::size_t at = text.find(usual); at != std::string::npos; at = text.find(usual, at + controller.size())) {
    text.replace(at, usual.size(), controller);
  }
  loadBuiltInPlugins();
  auto simulation = std::make_unique<Simulation>(parseExperiment(text, "test.xml"));
  simulation->start();
  return simulation;
}

Row rowOf(const Simulation& simulation) { return simulation.space().entities.find("fb"); }
double held(const Simulation& simulation, const char* property) {
  return *simulation.space().property(rowOf(simulation), property);
}
const BatteryState& stateOf(const Simulation& simulation) { return simulation.space().batteries[rowOf(simulation)][0]; }
double wayOf(const Simulation& simulation) { return poseOf(simulation, "fb").position.x() - 5.0; }
void set(Simulation& simulation, const std::string& property, double value) {
  simulation.apply(SetProperty{"fb", property, numberText(value)});
}

/// A wall 0.5 m ahead blocks the robot. By hand, at the fraction u of full voltage: 16 / 2 * u * u more for each wheel.
TEST(BatteryTest, ARobotThatIsHeldDrawsByItsLoad) {
  const double full = 0.3 / 0.029;  // rad/s
  for (const char* engine : {"kinematics2d", "dynamics2d"}) {
    for (const double speed : {full, 0.62 * full}) {
      World world = worldWith(battery(5000.0, 0.0) + "<battery_stall>20</battery_stall>",
                              "<left>" + numberText(speed) + "</left><right>" + numberText(speed) + "</right>");
      world.entities +=
          "<block id='wall'><position>5.6,5,0.25</position><orientation>0,0,0</orientation><size>0.2,4,0.5</size>"
          "</block>";
      world.members = "";
      world.engines = "<" + std::string(engine) + " id='other'/>";
      world.physics = "<engine id='other'><entity id='fb'/><entity id='wall'/></engine>";
      const auto simulation = world.make();
      simulation->start();
      const Row row = simulation->space().entities.find("fb");
      tick(*simulation, 10);  // the robot drives as commanded
      const double part = speed / full;
      EXPECT_NEAR(simulation->space().batteries[row][0].power, kStandby + 4.0 * part, 0.01) << engine;
      tick(*simulation, 40);  // the robot is blocked by the wall
      EXPECT_NEAR(simulation->space().batteries[row][0].power, kStandby + 4.0 * part + 16.0 * part * part, 0.1)
          << engine << " at " << speed;
    }
  }
}

TEST(BatteryTest, DrainsByWhatIsListedAndHowTheWheelsTurn) {
  const auto simulation = started("<battery>true</battery>", "<left>2</left><right>-3.7</right>");
  tick(*simulation, 37);
  const double power = kStandby + 5.7 * kPerWheel;
  EXPECT_NEAR(power, 4.842, 1e-9);
  EXPECT_NEAR(stateOf(*simulation).power, power, 1e-9);
  EXPECT_NEAR(stateOf(*simulation).used, 3.7 * power, 1e-9);
  EXPECT_NEAR(held(*simulation, "charge"), 133200.0 - 3.7 * power, 1e-7);
  EXPECT_EQ(held(*simulation, "capacitor"), 60.0);
}

TEST(BatteryTest, WheelsThatSlipDrawWhatTheyTurn) {
  std::string text = worldWith("<battery>true</battery>", "<left>2</left><right>-3.7</right>").xml();
  const std::string wheels = "<footbot_wheels/>";
  const std::size_t place = text.find(wheels);
  ASSERT_NE(place, std::string::npos);
  text.replace(place, wheels.size(),
               "<footbot_wheels><implementation>slipping</implementation><slip_left>0.41</slip_left>"
               "<slip_right>0.23</slip_right><slip_noise>0.1</slip_noise></footbot_wheels>");
  loadBuiltInPlugins();
  Simulation simulation(parseExperiment(text, "test.xml"));
  simulation.start();
  tick(simulation, 37);
  EXPECT_NEAR(stateOf(simulation).used, 3.7 * 4.842, 1e-9) << "as without slip";
}

TEST(BatteryTest, LedsDrawAsMuchAsTheyShine) {
  const auto simulation = startedWith("test_lights", "<battery>true</battery>");
  tick(*simulation, 3);
  EXPECT_NEAR(stateOf(*simulation).power, kStandby + 0.2 * (1.0 + 1.0 / 3.0 + 0.2), 1e-9);
}

TEST(BatteryTest, ARobotThatIsOffIsDark) {
  const auto simulation = startedWith("test_lights", battery(3.0, 0.0));
  tick(*simulation, 2);
  EXPECT_EQ(simulation->space().leds[rowOf(*simulation)][5], colors::kRed);
  tick(*simulation, 10);  // 3 J at 4.05 W: 7.4 ticks
  ASSERT_TRUE(stateOf(*simulation).is_empty);
  const Span<const Color> leds = simulation->space().leds[rowOf(*simulation)];
  EXPECT_EQ(leds.size(), FootbotLeds::kCount);
  for (const Color led : leds) {
    EXPECT_EQ(led, colors::kBlack);
  }
  set(*simulation, "charge", 3.0);
  tick(*simulation, 2);
  EXPECT_EQ(simulation->space().leds[rowOf(*simulation)][5], colors::kRed);
}

TEST(BatteryTest, ARobotIsOffInTheTickAfterTheLastOfItsCharge) {
  // 3 J at 0.4513 J a tick: 6.65 ticks
  const auto simulation = started(battery(3.0, 0.0), kAhead);
  tick(*simulation, 6);
  EXPECT_NEAR(held(*simulation, "charge"), 3.0 - 0.6 * kDriving, 1e-9);
  EXPECT_FALSE(stateOf(*simulation).is_empty);
  tick(*simulation, 1);
  EXPECT_EQ(held(*simulation, "charge"), 0.0);
  EXPECT_TRUE(stateOf(*simulation).is_empty);
  EXPECT_NEAR(stateOf(*simulation).used, 3.0, 1e-12);
  EXPECT_NEAR(wayOf(*simulation), 0.7 * 0.058, 1e-6);
  tick(*simulation, 20);
  EXPECT_NEAR(wayOf(*simulation), 0.7 * 0.058, 1e-6) << "it stands";
  EXPECT_EQ(stateOf(*simulation).power, 0.0) << "and draws nothing";
  EXPECT_NEAR(stateOf(*simulation).used, 3.0, 1e-12);
}

TEST(BatteryTest, ItGoesOnWithEnough) {
  const auto simulation = started(battery(3.0, 0.0), kAhead);
  tick(*simulation, 10);
  const double place = wayOf(*simulation);
  set(*simulation, "charge", 0.89);  // below 0.9 J, which is 0.3 of its capacity
  tick(*simulation, 5);
  EXPECT_EQ(wayOf(*simulation), place);
  EXPECT_EQ(held(*simulation, "charge"), 0.89);
  set(*simulation, "charge", 1.2);
  tick(*simulation, 2);
  EXPECT_NEAR(wayOf(*simulation), place + 0.2 * 0.058, 1e-6);
  EXPECT_FALSE(stateOf(*simulation).is_empty);
  tick(*simulation, 10);
  EXPECT_TRUE(stateOf(*simulation).is_empty) << "again";
}

TEST(BatteryTest, WhoeverElseCommandsItDoesSoOnceItIsCharged) {
  const auto simulation = started(battery(3.0, 0.0), kAhead);
  tick(*simulation, 10);
  const double place = wayOf(*simulation);
  simulation->apply(SetCommandSource{"fb", CommandSource::kController});
  tick(*simulation, 5);
  EXPECT_EQ(wayOf(*simulation), place) << "it is off";
  simulation->apply(SetCommandSource{"fb", CommandSource::kNone});
  set(*simulation, "charge", 3.0);
  tick(*simulation, 5);
  EXPECT_EQ(wayOf(*simulation), place) << "nobody shall command it";
  EXPECT_NEAR(stateOf(*simulation).power, kStandby, 1e-9) << "but it is on";
  simulation->apply(SetCommandSource{"fb", CommandSource::kController});
  tick(*simulation, 2);
  EXPECT_GT(wayOf(*simulation), place + 0.01);
}

/// A robot whose battery is empty after 9 ticks, and recharged sufficiently in tick 20.
std::unique_ptr<Simulation> chargedAgain(bool fails_in_step) {
  TestFailing::starts = 0;
  TestFailing::fails_in_step = fails_in_step;
  auto simulation = startedWith("test_failing", battery(3.0, 0.0));
  tick(*simulation, 20);
  EXPECT_TRUE(stateOf(*simulation).is_empty);
  set(*simulation, "charge", 3.0);
  tick(*simulation, 3);
  EXPECT_FALSE(stateOf(*simulation).is_empty);
  return simulation;
}

TEST(BatteryTest, AControllerThatCannotStartAnewHasFailedAndTheRunGoesOn) {
  const auto simulation = chargedAgain(false);
  EXPECT_EQ(TestFailing::starts, 2);
  ASSERT_EQ(simulation->failures().size(), 1U);
  EXPECT_NE(simulation->failures()[0].reason.find("after its battery was charged"), std::string::npos);
  EXPECT_NE(simulation->failures()[0].reason.find("twice"), std::string::npos);
  tick(*simulation, 20);  // its battery is empty again
  set(*simulation, "charge", 3.0);
  tick(*simulation, 3);
  EXPECT_EQ(simulation->failures().size(), 1U);
}

TEST(BatteryTest, AControllerThatHasFailedIsNotStartedAnew) {
  const auto simulation = chargedAgain(true);
  EXPECT_EQ(TestFailing::starts, 1);
  EXPECT_EQ(simulation->failures().size(), 1U);
}

TEST(BatteryTest, WhileItIsOffNobodyCanBeChosenWhoCannotCommandIt) {
  const auto simulation = started(battery(3.0, 0.0), kAhead);
  tick(*simulation, 10);
  try {
    simulation->apply(SetCommandSource{"fb", CommandSource::kTopics});
    ADD_FAILURE() << "nobody listens to topics here";
  } catch (const ConfigError& error) {
    EXPECT_NE(std::string(error.what()).find("'fb' cannot be commanded by topics: nobody listens"), std::string::npos);
  }
}

TEST(BatteryTest, TheSuperCapacitorBridgesWithWheelsOff) {
  // tick 3 takes the last 0.0973 J of the battery and 0.354 J of the capacitor; the remaining 9.646 J last 25.8 ticks
  // at rest
  const auto simulation = started(battery(1.0, 10.0), kAhead);
  tick(*simulation, 3);
  EXPECT_EQ(held(*simulation, "charge"), 0.0);
  EXPECT_NEAR(held(*simulation, "capacitor"), 11.0 - 0.3 * kDriving, 1e-9);
  tick(*simulation, 1);
  EXPECT_NEAR(stateOf(*simulation).power, kStandby, 1e-9);
  EXPECT_NEAR(wayOf(*simulation), 0.3 * 0.058, 1e-6);
  tick(*simulation, 24);
  EXPECT_FALSE(stateOf(*simulation).is_empty);
  tick(*simulation, 1);
  EXPECT_TRUE(stateOf(*simulation).is_empty);
  EXPECT_NEAR(stateOf(*simulation).used, 11.0, 1e-9);
}

TEST(BatteryTest, AFootbotsSuperCapacitorLastsLongerThanASwap) {
  const auto simulation = started("<battery>true</battery>", kStill);
  set(*simulation, "charge", 0.0);
  tick(*simulation, 150);
  EXPECT_FALSE(stateOf(*simulation).is_empty);
  EXPECT_NEAR(held(*simulation, "capacitor"), 60.0 - 15.0 * kStandby, 1e-9);
  tick(*simulation, 11);
  EXPECT_TRUE(stateOf(*simulation).is_empty) << "60 J last for 16.04 s";
}

TEST(BatteryTest, TheBatteryRefillsTheSuperCapacitor) {
  const auto simulation = started(battery(100.0, 6.0), kStill);
  set(*simulation, "capacitor", 3.0);
  tick(*simulation, 7);
  EXPECT_NEAR(held(*simulation, "capacitor"), 3.07, 1e-9) << "in a minute when it was empty";
  EXPECT_NEAR(held(*simulation, "charge"), 100.0 - 0.7 * kStandby - 0.07, 1e-9);
}

TEST(BatteryTest, ASupplyChargesItUpToItsCapacity) {
  const auto simulation = started(battery(100.0, 0.0, 0.5), kStill);
  set(*simulation, "supply", 23.0);
  tick(*simulation, 11);
  EXPECT_NEAR(held(*simulation, "charge"), 50.0 + 1.1 * (23.0 - kStandby), 1e-9);
  EXPECT_NEAR(stateOf(*simulation).input, 23.0, 1e-9);
  tick(*simulation, 20);
  EXPECT_EQ(held(*simulation, "charge"), 100.0);
  EXPECT_NEAR(stateOf(*simulation).input, kStandby, 1e-9) << "no more than is drawn";
  EXPECT_NEAR(stateOf(*simulation).received - stateOf(*simulation).used, 50.0, 1e-9) << "nothing is lost";
}

TEST(BatteryTest, WhatIsOutOfBoundsIsRefused) {
  const auto simulation = started(battery(100.0, 6.0), kStill);
  EXPECT_THROW(set(*simulation, "charge", 100.5), ConfigError);
  EXPECT_THROW(set(*simulation, "capacitor", -1.0), ConfigError);
  EXPECT_THROW(set(*simulation, "supply", -1.0), ConfigError);
  const auto without = started("", kStill);
  EXPECT_THROW(set(*without, "charge", 1.0), ConfigError);
}

TEST(BatteryTest, NumbersOfABatteryThatARobotDoesNotHaveAreRefused) {
  const auto refusalOf = [](const std::string& name, const std::string& number) -> std::string {
    try {
      worldWith("\n<" + name + ">" + number + "</" + name + ">", kStill).make();
      return "";
    } catch (const ConfigError& error) {
      return error.what();
    }
  };
  const std::string allowed = " for a robot without a battery, allowed: with <battery>true</battery>, or ";
  EXPECT_EQ(refusalOf("battery_capacity", "7.5"), "test.xml:2: battery_capacity: found '7.5'" + allowed + "133200");
  EXPECT_EQ(refusalOf("battery_level", "0.99"), "test.xml:2: battery_level: found '0.99'" + allowed + "1");
  EXPECT_EQ(refusalOf("battery_capacitor", "0"), "test.xml:2: battery_capacitor: found '0'" + allowed + "60");
  EXPECT_EQ(refusalOf("battery_enough", "0.31"), "test.xml:2: battery_enough: found '0.31'" + allowed + "0.3");
  EXPECT_EQ(refusalOf("battery_enough", "0.30"), "") << "as it is without it";
}

TEST(BatteryTest, ARobotWithoutOneHasTheHashesThatItAlwaysHad) {
  const auto hashes = [](const std::string& battery) { return hashesOf(*started(battery, kAhead), 30); };
  const auto plain = hashes("");
  EXPECT_EQ(hashes("<battery>false</battery><battery_capacity>133200</battery_capacity>"), plain);
  EXPECT_NE(hashes("<battery>true</battery>"), plain);
}

TEST(BatteryTest, AResetFillsItAndTheBitsAreTheSame) {
  World world = worldWith(battery(3.0, 1.5), kAhead);
  const auto run = [&world](int threads) {
    world.framework = "<threads>" + std::to_string(threads) + "</threads>";
    auto simulation = world.make();
    simulation->start();
    return simulation;
  };
  const auto used = run(1);
  const auto expected = hashesOf(*used, 60);
  EXPECT_TRUE(stateOf(*used).is_empty);
  used->reset();
  EXPECT_EQ(held(*used, "charge"), 3.0);
  EXPECT_EQ(held(*used, "capacitor"), 1.5);
  EXPECT_FALSE(stateOf(*used).is_empty);
  EXPECT_EQ(hashesOf(*used, 60), expected);
  EXPECT_EQ(hashesOf(*run(2), 60), expected) << "on two threads";
}

TEST(BatteryTest, ARobotThatIsDeletedAndSpawnedAgainIsFull) {
  World world = worldWith(battery(3.0, 0.0), kAhead);
  const auto simulation = world.make();
  simulation->start();
  tick(*simulation, 10);
  simulation->apply(DeleteEntity{"fb"});
  tick(*simulation, 1);
  EXPECT_TRUE(simulation->space().powered.empty());
  simulation->apply(SpawnEntity{simulation->experiment().arena.entities.front(), {"ground"}});
  tick(*simulation, 6);
  EXPECT_NEAR(held(*simulation, "charge"), 3.0 - 0.6 * kDriving, 1e-9);
}

}  // namespace
}  // namespace swarmanoid::test

REGISTER_CONTROLLER(swarmanoid::test::TestLights, "test_lights")
REGISTER_CONTROLLER(swarmanoid::test::TestFailing, "test_failing")
