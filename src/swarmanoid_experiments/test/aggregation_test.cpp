// The installed experiment `aggregation`: footbots with a one-bit sensor aggregate, the better the longer their range
// (Gauci et al. 2014 prove that the range must be long enough), and not at all if the bit is always 0.
#include <gtest/gtest.h>

#include "installed_experiment.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

// Limits of this test; ./test --long uses twenty seeds and four ranges.
constexpr std::uint64_t kSeeds = 2;
constexpr double kTogether = 0.9;     // minimum fraction of robots in the largest cluster at the end
constexpr double kTimesAsMuch = 5.0;  // minimum ratio of second moments: short-sighted or blind robots to the others

struct Result {
  double second_moment = 0.0;
  double largest_cluster = 0.0;
};

Result run(std::uint64_t seed, const std::vector<std::string>& overrides = {}) {
  const auto simulation = installed("aggregation", seed, overrides);
  finish(*simulation);
  EXPECT_TRUE(simulation->failures().empty());
  return {metricOf(*simulation, "dispersion.second_moment"), metricOf(*simulation, "dispersion.largest_cluster")};
}

TEST(AggregationTest, FootbotsThatSeeFarComeTogetherAndOthersDoNot) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    const Result far = run(seed);
    EXPECT_GE(far.largest_cluster, kTogether);
    for (const char* override :
         {"controllers.ac.sensors.footbot_camera.range=0.75", "controllers.ac.parameters.color=black"}) {
      const Result other = run(seed, {override});
      EXPECT_GT(other.second_moment, kTimesAsMuch * far.second_moment) << override;
      EXPECT_LT(other.largest_cluster, kTogether) << override;
    }
  }
}

TEST(AggregationTest, TheSameSeedGivesTheSameBits) {
  const auto expected = hashesOf(*installed("aggregation", 4), 100);
  EXPECT_EQ(hashesOf(*installed("aggregation", 4, {}, 2), 100), expected) << "on two threads";
  EXPECT_NE(hashesOf(*installed("aggregation", 5), 100), expected) << "another seed";
}

}  // namespace
}  // namespace swarmanoid::test
