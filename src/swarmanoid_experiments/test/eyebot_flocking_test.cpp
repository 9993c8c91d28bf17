// The installed experiment `eyebot_flocking`: four eyebots form a regular tetrahedron whose edges have the equilibrium
// distance of the force, which requires three dimensions; twelve fly together in one direction, without collisions.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "installed_experiment.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

constexpr double kDistance = 1.5;  // m, as in the experiment

std::vector<Eigen::Vector3d> places(const Simulation& simulation, int count) {
  std::vector<Eigen::Vector3d> found;
  for (int i = 1; i <= count; ++i) {
    found.push_back(poseOf(simulation, "eb_" + std::to_string(i)).position);
  }
  return found;
}

/// The distance from each position to the nearest other one [m].
std::vector<double> nearestDistances(const std::vector<Eigen::Vector3d>& places) {
  std::vector<double> nearest(places.size(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = 0; j < places.size(); ++j) {
      nearest[i] = i == j ? nearest[i] : std::min(nearest[i], (places[i] - places[j]).norm());
    }
  }
  return nearest;
}

TEST(EyebotFlockingTest, FourWithoutNoiseAreARegularTetrahedron) {
  const std::string sensors = "controllers.ec.sensors.";
  const std::string board = sensors + "range_and_bearing_received.";
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto simulation = installed(
        "eyebot_flocking", seed,
        {"arena.distribute.quantity=4", board + "range_noise.deviation=0", board + "bearing_noise.deviation=0",
         board + "elevation_noise.deviation=0", sensors + "positioning.heading_noise.deviation=0"});
    finish(*simulation);
    const std::vector<Eigen::Vector3d> corners = places(*simulation, 4);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_NEAR((corners[i] - corners[j]).norm(), kDistance, 0.005) << "seed " << seed << ", edge " << i << j;
      }
    }
    EXPECT_GT(metricOf(*simulation, "flock.order"), 0.999) << "seed " << seed;
  }
}

TEST(EyebotFlockingTest, TwelveFlyInOneDirectionStayTogetherAndDoNotTouch) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    const auto simulation = installed("eyebot_flocking", seed);
    finish(*simulation);
    EXPECT_TRUE(simulation->failures().empty());
    EXPECT_GT(metricOf(*simulation, "flock.mean_order"), 0.98);
    EXPECT_EQ(metricOf(*simulation, "contacts.collisions"), 0.0);
    EXPECT_EQ(metricOf(*simulation, "clusters.number"), 1.0);
    // at 0.3 m/s with the compass noise of 0.05 rad, in each one's own heading and in the messages
    EXPECT_NEAR(metricOf(*simulation, "flock.speed"), 0.3, 0.01);
    const std::vector<Eigen::Vector3d> eyebots = places(*simulation, 12);
    const auto [low, high] = std::minmax_element(eyebots.begin(), eyebots.end(),
                                                 [](const auto& one, const auto& two) { return one.z() < two.z(); });
    EXPECT_GT(high->z() - low->z(), kDistance) << "it has more than one layer";
    EXPECT_GT(low->z(), 2.0) << "the lowest height that they want";
    // closer than in a group of four, because second neighbours attract too
    const std::vector<double> nearest = nearestDistances(eyebots);
    EXPECT_GT(*std::min_element(nearest.begin(), nearest.end()), 0.7 * kDistance);
    EXPECT_NEAR(std::accumulate(nearest.begin(), nearest.end(), 0.0) / 12.0, 0.9 * kDistance, 0.05 * kDistance);
  }
}

TEST(EyebotFlockingTest, WithoutAlignmentThereIsNoFlock) {
  // the mean order of twelve random headings is sqrt(pi / (4 12)) = 0.26, and one sample of 75 is over 0.6
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto simulation = installed("eyebot_flocking", seed, {"controllers.ec.parameters.alignment=false"});
    finish(*simulation);
    EXPECT_LT(metricOf(*simulation, "flock.mean_order"), 0.6) << "seed " << seed;
    EXPECT_GT(metricOf(*simulation, "clusters.number"), 1.0) << "seed " << seed;
  }
}

TEST(EyebotFlockingTest, TheSameSeedGivesTheSameBits) {
  const auto expected = hashesOf(*installed("eyebot_flocking", 4), 100);
  EXPECT_EQ(hashesOf(*installed("eyebot_flocking", 4, {}, 2), 100), expected) << "on two threads";
  EXPECT_NE(hashesOf(*installed("eyebot_flocking", 5), 100), expected) << "another seed";
}

}  // namespace
}  // namespace swarmanoid::test
