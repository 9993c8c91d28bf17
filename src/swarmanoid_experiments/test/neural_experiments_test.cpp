// The installed experiments with evolved networks: they solve their tasks with seeds that evolution did not use, and do
// not without the evolved numbers.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "installed_experiment.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

// Limits of this test. Over 100 unseen seeds the means are 0.29 m (1.1 for a hand-written controller), 0.97, and 433
// ticks (933 for a hand-written one).
constexpr std::uint64_t kFirstSeed = 301;
constexpr std::uint64_t kSeeds = 4;
constexpr double kAtTheLamp = 0.5;      // m, mean distance of the robots just before a switch
constexpr double kNotAtTheLamp = 1.2;   // m, for a network with equal outputs in the light and in the dark
constexpr double kTogether = 0.8;       // fraction of the robots in the largest cluster
constexpr double kApart = 0.5;          // maximum for robots that do not hear each other
constexpr double kFastRetrieval = 0.8;  // maximum ratio of ticks to the experiment that was not evolved

double mean(const std::string& experiment, const std::string& metric, const std::vector<std::string>& overrides = {}) {
  double sum = 0.0;
  for (std::uint64_t seed = kFirstSeed; seed < kFirstSeed + kSeeds; ++seed) {
    const auto simulation = installed(experiment, seed, overrides);
    finish(*simulation);
    EXPECT_TRUE(simulation->failures().empty());
    sum += metricOf(*simulation, metric);
  }
  return sum / static_cast<double>(kSeeds);
}

TEST(NeuralExperimentsTest, FootbotsDriveToTheLampAroundWalls) {
  EXPECT_LT(mean("neural_phototaxis", "lamps.distance_before_switch"), kAtTheLamp);
  EXPECT_GT(mean("neural_phototaxis", "lamps.distance_before_switch", {"rules.lamps.intensity=0"}), kNotAtTheLamp);
}

TEST(NeuralExperimentsTest, FootbotsComeTogetherIfTheyHearEachOther) {
  EXPECT_GT(mean("neural_aggregation", "dispersion.largest_cluster"), kTogether);
  EXPECT_LT(mean("neural_aggregation", "dispersion.largest_cluster",
                 {"controllers.nc.sensors.range_and_bearing_received.range=0.01"}),
            kApart);
}

TEST(NeuralExperimentsTest, EvolvedRetrievalIsFaster) {
  EXPECT_LT(mean("evolved_retrieval", "retrieval_ticks"), kFastRetrieval * mean("object_retrieval", "retrieval_ticks"));
}

TEST(NeuralExperimentsTest, TheSameSeedGivesTheSameBits) {
  for (const char* name : {"neural_phototaxis", "neural_aggregation"}) {
    const auto expected = hashesOf(*installed(name, 4), 100);
    EXPECT_EQ(hashesOf(*installed(name, 4, {}, 2), 100), expected) << name << " on two threads";
    EXPECT_NE(hashesOf(*installed(name, 5), 100), expected) << name << " with another seed";
  }
}

TEST(NeuralExperimentsTest, AResetForgetsWhatTheNetworkRemembers) {
  const auto simulation = installed("neural_aggregation", 4);
  const auto expected = hashesOf(*simulation, 100);
  simulation->reset(4, true);
  EXPECT_EQ(hashesOf(*simulation, 100), expected);
}

}  // namespace
}  // namespace swarmanoid::test
