// Foraging on batteries, the installed experiment: robots that recharge keep delivering preys; the others stop with
// empty batteries. The larger the group, the fewer preys per used energy.
#include <gtest/gtest.h>

#include "installed_experiment.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

std::unique_ptr<Simulation> foraging(std::uint64_t seed, const std::vector<std::string>& overrides, int threads = 1) {
  return installed("battery_foraging", seed, overrides, threads);
}

std::string robots(int count) { return "arena.distribute.quantity=" + std::to_string(count); }
constexpr const char* kNeverCharged = "controllers.fc.parameters.little=0";

void runUntil(Simulation& simulation, double seconds) {
  while (!simulation.isFinished() && toSeconds(simulation.space().time - kEpoch) < seconds - 1e-6) {
    simulation.tick();
  }
  EXPECT_TRUE(simulation.failures().empty());
}

constexpr double kDuration = 600.0;  // s

TEST(BatteryForagingTest, TheEfficiencyIsPreysForWhatRobotsHaveUsed) {
  const auto simulation = foraging(2, {robots(3)});
  runUntil(*simulation, 311.0);
  const double preys = metricOf(*simulation, "foraging.preys");
  const double used = metricOf(*simulation, "charging.drained");
  ASSERT_GT(preys, 0.0);
  EXPECT_NEAR(metricOf(*simulation, "foraging.preys_per_kilojoule"), 1000.0 * preys / used, 1e-9);
}

TEST(BatteryForagingTest, ColoursThatMeanTwoThingsAreRefused) {
  const auto expectRefused = [](const std::string& parameter, const std::string& color, const std::string& message) {
    try {
      foraging(1, {"controllers.fc.parameters." + parameter + "=" + color});
      FAIL() << parameter << " was not refused";
    } catch (const ConfigError& error) {
      EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
    }
  };
  expectRefused("free_color", "green",
                "free_color: found 'green', which is nest_color too, allowed: a colour of its own");
  expectRefused("taken_color", "blue", "taken_color: found 'blue', which is the light of whoever carries too, allowed");
  expectRefused("free_color", "magenta", "free_color: found 'magenta', which is charging_color too, allowed");
}

TEST(BatteryForagingTest, WhoIsChargedKeepsGoing) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto simulation = foraging(seed, {});
    runUntil(*simulation, 300.0);
    const double preys = metricOf(*simulation, "foraging.preys");
    runUntil(*simulation, kDuration);
    EXPECT_EQ(metricOf(*simulation, "charging.empty"), 0.0) << "seed " << seed;
    EXPECT_GT(metricOf(*simulation, "foraging.preys"), preys + 4.0) << "seed " << seed;
  }
}

// Electronics, proximity sensors, camera and gripper draw 4.74 W, wheels at most 4 W and blue LEDs 0.8 W. A battery of
// 1000 J is empty after at least 105 s, and with the capacitor's 60 J after at most 224 s.
TEST(BatteryForagingTest, WhoIsNeverChargedStandsStill) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto simulation = foraging(seed, {kNeverCharged});
    runUntil(*simulation, 1000.0 / 9.54);
    EXPECT_EQ(metricOf(*simulation, "charging.ran_empty"), 0.0) << "seed " << seed;
    runUntil(*simulation, 1060.0 / 4.74 + 1.0);
    EXPECT_EQ(metricOf(*simulation, "charging.empty"), 4.0) << "seed " << seed;
    const double preys = metricOf(*simulation, "foraging.preys");
    runUntil(*simulation, kDuration);
    EXPECT_EQ(metricOf(*simulation, "charging.empty"), 4.0) << "seed " << seed;
    EXPECT_EQ(metricOf(*simulation, "foraging.preys"), preys) << "seed " << seed;
  }
}

TEST(BatteryForagingTest, InALargerGroupEachBringsLess) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    std::vector<double> efficiency;  // 1/kJ
    for (const int count : {2, 5, 11}) {
      const auto simulation = foraging(seed, {robots(count)});
      runUntil(*simulation, kDuration);
      efficiency.push_back(metricOf(*simulation, "foraging.preys_per_kilojoule"));
    }
    EXPECT_GT(efficiency[0], efficiency[1]) << "seed " << seed;
    EXPECT_GT(efficiency[1], efficiency[2]) << "seed " << seed;
  }
}

TEST(BatteryForagingTest, TheSameSeedGivesTheSameBits) {
  const auto expected = hashesOf(*foraging(3, {}), 1500);
  EXPECT_EQ(hashesOf(*foraging(3, {}, 2), 1500), expected) << "on two threads";
  const auto used = foraging(4, {});
  hashesOf(*used, 700);
  used->reset(3);
  EXPECT_EQ(hashesOf(*used, 1500), expected) << "after a reset";
}

}  // namespace
}  // namespace swarmanoid::test
