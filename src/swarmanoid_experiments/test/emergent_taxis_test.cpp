// The installed experiment `emergent_taxis`: a swarm whose robots do not measure the direction of the light moves to
// it, the slower the more of them have failed motors (Bjerknes and Winfield 2010: they anchor it). It does not if
// robots keep the same distance in light and shadow, or without a light.
#include <gtest/gtest.h>

#include "installed_experiment.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

// Limits of this test; ./test --long uses twenty seeds and one value more.
constexpr std::uint64_t kSeeds = 2;
constexpr double kTrend = -0.6;  // maximum of Kendall's tau of the progress over the number of failures
constexpr double kPart = 0.5;    // maximum fraction of that progress without the mechanism

/// @return progress of the swarm towards the light [m]
double progress(std::uint64_t seed, int failures, const std::vector<std::string>& overrides = {}) {
  const auto simulation = installed("emergent_taxis", seed, overrides);
  ErrorModelDescription dead;
  dead.kind = "dead";
  for (int i = 1; i <= failures; ++i) {
    simulation->apply(SetFault{"fb_" + std::to_string(i), "footbot_wheels", {dead}});
  }
  finish(*simulation);
  EXPECT_TRUE(simulation->failures().empty());
  return metricOf(*simulation, "taxis.progress");
}

TEST(EmergentTaxisTest, FailedMotorsAnchorASwarmThatComesToTheLightByTwoRadii) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    std::vector<double> ways;
    for (const int failures : {0, 1, 2}) {
      ways.push_back(progress(seed, failures));
    }
    EXPECT_LT(kendall(ways), kTrend) << "seed " << seed;
    for (const char* override : {"arena.beacon.intensity=0", "controllers.tc.parameters.radius_in_light=0.35"}) {
      EXPECT_LT(progress(seed, 0, {override}), kPart * ways.front()) << "seed " << seed << ", " << override;
    }
  }
}

TEST(EmergentTaxisTest, TheSameSeedGivesTheSameBits) {
  const auto expected = hashesOf(*installed("emergent_taxis", 4), 300);
  EXPECT_EQ(hashesOf(*installed("emergent_taxis", 4, {}, 2), 300), expected) << "on two threads";
  EXPECT_NE(hashesOf(*installed("emergent_taxis", 5), 300), expected) << "another seed";
}

}  // namespace
}  // namespace swarmanoid::test
