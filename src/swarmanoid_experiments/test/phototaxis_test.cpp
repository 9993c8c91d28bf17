// The installed experiment `phototaxis`: footbots follow the light from lamp to lamp, but not if it does not switch or
// if they cannot detect it.
#include <gtest/gtest.h>

#include <fstream>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

// Limits of this test. The lamps are 3 m apart, and in 40 s a robot can drive 6 m.
constexpr std::uint64_t kHalfPeriod = 400;  // ticks during which a lamp is lit
constexpr double kArrived = 0.7;            // m, maximum mean distance of robots that have reached the lamp
constexpr double kNotArrived = 1.3;         // m, minimum mean distance of robots that have not

/// @param found part of the file to replace; "": none @param put its replacement
std::unique_ptr<Simulation> phototaxis(std::uint64_t seed, const std::string& found = "", const std::string& put = "",
                                       int threads = 1) {
  loadBuiltInPlugins();
  std::ifstream file(findShared("swarmanoid_experiments", "experiments/phototaxis.xml"));
  std::string text(std::istreambuf_iterator<char>(file), {});
  if (!found.empty()) {
    const std::size_t at = text.find(found);
    EXPECT_NE(at, std::string::npos) << found;
    text.replace(at, found.size(), put);
  }
  Experiment experiment = parseExperiment(text, "phototaxis.xml");
  experiment.framework.seed = seed;
  experiment.framework.threads = threads;
  auto simulation = std::make_unique<Simulation>(std::move(experiment));
  simulation->start();
  return simulation;
}

void tickUntil(Simulation& simulation, std::uint64_t tick) {
  while (simulation.space().tick < tick) {
    simulation.tick();
  }
}

/// In the horizontal plane; computed independently of the rule.
double meanDistance(const Simulation& simulation, const std::string& lamp) {
  double sum = 0.0;
  for (const char* robot : {"fb_1", "fb_2", "fb_3", "fb_4"}) {
    const Eigen::Vector3d offset = poseOf(simulation, robot).position - poseOf(simulation, lamp).position;
    sum += std::hypot(offset.x(), offset.y());
  }
  return sum / 4.0;
}

double metricOf(const Simulation& simulation, const std::string& name) {
  return std::get<double>(simulation.metrics().at("lamps." + name));
}

TEST(PhototaxisTest, FootbotsAreAtTheLampThatIsLitBeforeItGoesOff) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto simulation = phototaxis(seed);
    for (std::uint64_t half = 1; half <= 4; ++half) {
      const std::string lit = half % 2 == 1 ? "west" : "east";
      tickUntil(*simulation, half * kHalfPeriod);
      EXPECT_LT(meanDistance(*simulation, lit), kArrived) << "seed " << seed << ", half " << half;
      EXPECT_NEAR(metricOf(*simulation, "distance"), meanDistance(*simulation, lit), 1e-9);
    }
    simulation->tick();
    EXPECT_EQ(metricOf(*simulation, "switches"), 4.0);
    EXPECT_LT(metricOf(*simulation, "distance_before_switch"), kArrived) << "seed " << seed;
    EXPECT_GT(metricOf(*simulation, "distance"), kNotArrived) << "just after a switch they have the way before them";
    EXPECT_TRUE(simulation->failures().empty());
  }
}

TEST(PhototaxisTest, LampsThatDoNotSwitchKeepThemWhereTheyAre) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto simulation = phototaxis(seed, "<period>80</period>", "<period>80</period><duty>1</duty>");
    tickUntil(*simulation, 2 * kHalfPeriod);
    EXPECT_LT(meanDistance(*simulation, "west"), kArrived) << "seed " << seed;
    EXPECT_GT(meanDistance(*simulation, "east"), kNotArrived) << "seed " << seed;
  }
}

TEST(PhototaxisTest, RobotsThatDoNotSeeLightDoNotFollowIt) {
  const std::string sensor = "<error kind=\"factor_spread\" field=\"sensors[].value\" deviation=\"0.1\"/>";
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto simulation = phototaxis(seed, sensor, "<error kind=\"dead\" field=\"sensors\"/>");
    for (std::uint64_t half = 1; half <= 2; ++half) {
      tickUntil(*simulation, half * kHalfPeriod);
      EXPECT_GT(meanDistance(*simulation, half % 2 == 1 ? "west" : "east"), kNotArrived) << "seed " << seed;
    }
  }
}

TEST(PhototaxisTest, TheSameSeedGivesTheSameBits) {
  const auto expected = hashesOf(*phototaxis(4), 2 * kHalfPeriod);
  EXPECT_EQ(hashesOf(*phototaxis(4, "", "", 2), 2 * kHalfPeriod), expected) << "on two threads";
  EXPECT_NE(hashesOf(*phototaxis(5), 2 * kHalfPeriod), expected) << "another seed";
}

}  // namespace
}  // namespace swarmanoid::test
