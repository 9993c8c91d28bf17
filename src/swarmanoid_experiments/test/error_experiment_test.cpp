// <error> in whole experiments: from the file to the readings of controllers and the motion of robots.
#include <gtest/gtest.h>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

/// The world with these errors.
std::string withErrors(const World& world, const std::string& of_wheels, const std::string& of_proximity) {
  std::string text = world.xml();
  const auto fill = [&text](const std::string& tag, const std::string& inside) {
    text.replace(text.find("<" + tag + "/>"), tag.size() + 3, "<" + tag + ">" + inside + "</" + tag + ">");
  };
  fill("footbot_wheels", of_wheels);
  fill("footbot_proximity", of_proximity);
  return text;
}

std::unique_ptr<Simulation> started(const std::string& text, const std::vector<Override>& overrides = {}) {
  loadBuiltInPlugins();
  auto simulation = std::make_unique<Simulation>(parseExperiment(text, "test.xml", overrides));
  simulation->start();
  return simulation;
}

World oneRobot() {
  World world;
  world.entities = footbot("fb", 5.0, 5.0, 0.0);
  world.members = member("fb");
  world.drive = "<left>5</left><right>5</right>";
  return world;
}

World crowd(int threads) {
  World world;
  world.framework = "<threads>" + std::to_string(threads) + "</threads>";
  world.entities =
      "<distribute quantity=\"150\" layout=\"grid\"><minimum>0.5,0.5,0</minimum><maximum>9,9,0</maximum>"
      "<footbot id=\"fb\"><controller>drive</controller></footbot></distribute>";
  world.members = member("fb");
  world.drive = "<left>0</left><right>0</right><random>true</random>";
  return world;
}

/// Hashes of the next ticks: the state hash does not cover readings, the deep one does.
struct RunHashes {
  std::vector<std::uint64_t> state;
  std::vector<std::uint64_t> deep;
};

RunHashes runHashesOf(Simulation& simulation, int ticks) {
  RunHashes hashes;
  for (int i = 0; i < ticks; ++i) {
    simulation.tick();
    hashes.state.push_back(simulation.stateHash());
    hashes.deep.push_back(deepHash(simulation.space()));
  }
  return hashes;
}

const char* const kManyErrors =
    "<error kind=\"factor_spread\" deviation=\"0.1\"/><error kind=\"random_walk\" deviation=\"0.05\"/>"
    "<error kind=\"latency\" ticks=\"3\"/><error kind=\"drop_out\" probability=\"0.2\"/>"
    "<error kind=\"stuck\" field=\"left\" from_tick=\"40\"/>";

TEST(ErrorExperimentTest, WheelsThatAreLateStandStillForSoLong) {
  const double tick_way = 0.1 * 5.0 * FootbotWheels::kRadius;
  for (const int late : {1, 4}) {
    auto simulation =
        started(withErrors(oneRobot(), "<error kind=\"latency\" ticks=\"" + std::to_string(late) + "\"/>", ""));
    for (int tick = 1; tick <= 10; ++tick) {
      simulation->tick();
      EXPECT_NEAR(poseOf(*simulation, "fb").position.x(), 5.0 + tick_way * std::max(0, tick - late), 1e-9);
    }
  }
}

TEST(ErrorExperimentTest, ADeadWheelTurnsTheRobotFromItsTickOn) {
  auto simulation = started(withErrors(oneRobot(), "<error kind=\"dead\" field=\"left\" from_tick=\"10\"/>", ""));
  hashesOf(*simulation, 10);
  EXPECT_EQ(headingOf(*simulation, "fb"), 0.0);
  hashesOf(*simulation, 1);
  EXPECT_NEAR(headingOf(*simulation, "fb"), 0.1 * 5.0 * FootbotWheels::kRadius / FootbotWheels::kSeparation, 1e-9);
}

TEST(ErrorExperimentTest, TheReadingsInTheSpaceAreTheDeliveredOnes) {
  auto simulation = started(withErrors(oneRobot(), "", "<error kind=\"bias\" field=\"value[3]\" offset=\"0.25\"/>"));
  simulation->tick();
  const Space& space = simulation->space();
  const auto* readings = space.readings.find<FootbotProximity>(space.entities.find("fb"));
  for (std::size_t i = 0; i < FootbotProximity::kCount; ++i) {
    EXPECT_EQ(readings->value[i], i == 3 ? 0.25F : 0.0F);
  }
}

TEST(ErrorExperimentTest, OverridesReachAnErrorByItsTagOrItsId) {
  const std::string text = withErrors(oneRobot(),
                                      "<error kind=\"bias\" field=\"left\" offset=\"1\" id=\"drag\"/>"
                                      "<error kind=\"bias\" field=\"right\" offset=\"1\"/>",
                                      "<error kind=\"dead\"/>");
  auto plain = started(text);
  auto changed = started(text, {{"controllers.drive.actuators.footbot_wheels.drag.offset", "2"},
                                {"controllers.drive.sensors.footbot_proximity.error.from_tick", "7"}});
  hashesOf(*plain, 5);
  hashesOf(*changed, 5);
  EXPECT_EQ(headingOf(*plain, "fb"), 0.0);
  EXPECT_LT(headingOf(*changed, "fb"), 0.0);
  EXPECT_THROW(started(text, {{"controllers.drive.actuators.footbot_wheels.drag.offset", "much"}}), ConfigError);
}

TEST(ErrorExperimentTest, AResetAndAnyNumberOfThreadsGiveTheSameBits) {
  const char* const noisy = "<error kind=\"gaussian\" deviation=\"0.2\"/>";
  auto fresh = started(withErrors(crowd(1), kManyErrors, noisy));
  const RunHashes expected = runHashesOf(*fresh, 90);
  for (const int threads : {1, 4}) {
    auto used = started(withErrors(crowd(threads), kManyErrors, noisy));
    for (const char* run : {"first", "after a reset"}) {
      const RunHashes hashes = runHashesOf(*used, 90);
      EXPECT_EQ(hashes.state, expected.state) << threads << " threads, " << run;
      EXPECT_EQ(hashes.deep, expected.deep) << threads << " threads, " << run;
      used->reset();
    }
  }
  auto without = started(crowd(1).xml());
  EXPECT_NE(runHashesOf(*without, 90).state, expected.state);
  auto without_noise = started(withErrors(crowd(1), kManyErrors, ""));
  const RunHashes of_commands = runHashesOf(*without_noise, 90);
  EXPECT_EQ(of_commands.state, expected.state) << "this controller does not read the sensor";
  EXPECT_NE(of_commands.deep, expected.deep);
}

TEST(ErrorExperimentTest, ATickWithErrorsAllocatesNothing) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  const auto allocations = [](const std::string& text) {
    auto simulation = started(text);
    hashesOf(*simulation, 10);
    const long before = heap_allocations;
    for (int i = 0; i < 20; ++i) {
      simulation->tick();
    }
    return heap_allocations - before;
  };
  World world = oneRobot();
  EXPECT_EQ(allocations(world.xml()), 0);
  EXPECT_EQ(
      allocations(withErrors(world, kManyErrors,
                             "<error kind=\"gaussian\" deviation=\"0.1\"/><error kind=\"latency\" ticks=\"5\"/>")),
      0);
}

}  // namespace
}  // namespace swarmanoid::test
