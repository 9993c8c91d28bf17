// The rule `robot_clusters`: its metrics for robots at known positions, and compared with a check of all pairs.
#include <algorithm>
#include <random>

#include "measured_run.hpp"

namespace swarmanoid::test {
namespace {

std::string rule(double distance, const std::string& more = "") {
  return "<robot_clusters id='r'><robots>fb_</robots><distance>" + numberText(distance) + "</distance>" + more +
         "</robot_clusters>";
}

TEST(RobotClustersTest, ChainsOfNearRobotsAreClusters) {
  // a chain of three around a corner, a pair, one alone: steps of 0.47 m and 0.51 m, in arbitrary directions
  const double bend = 0.83;  // rad
  const Stand a{2.1, 1.3, 0.0};
  const Stand b{a.x + 0.47 * std::cos(0.31), a.y + 0.47 * std::sin(0.31), 0.0};
  const Stand c{b.x + 0.47 * std::cos(bend), b.y + 0.47 * std::sin(bend), 0.0};
  const Stand d{c.x + 0.51 * std::cos(bend), c.y + 0.51 * std::sin(bend), 0.0};
  const Stand e{d.x + 0.47, d.y, 0.0};
  const MeasuredRun run(rule(0.49), {a, b, c, d, e, {7.7, 0.6, 0.0}});
  EXPECT_EQ(run.metric("number"), 3.0);
  EXPECT_EQ(run.metric("mean_size"), 2.0);
  EXPECT_EQ(run.metric("largest"), 3.0);
}

TEST(RobotClustersTest, ARobotBetweenTwoClustersMakesThemOne) {
  MeasuredRun run(rule(0.3), {{1.0, 1.0}, {1.25, 1.0}, {1.75, 1.0}, {2.0, 1.0}, {6.0, 6.0}, {1.5, 7.0}});
  EXPECT_EQ(run.metric("number"), 4.0) << "before the first tick, too";
  run.put("fb_6", {1.5, 1.0});
  run.tick();
  EXPECT_EQ(run.metric("number"), 2.0);
  EXPECT_EQ(run.metric("mean_size"), 3.0);
  EXPECT_EQ(run.metric("largest"), 5.0);
  run.remove("fb_6");
  run.tick();
  EXPECT_EQ(run.metric("number"), 3.0);
  EXPECT_NEAR(run.metric("mean_size"), 5.0 / 3.0, 1e-15);
}

TEST(RobotClustersTest, WithoutRobotsAllIsZeroAlsoAfterAReset) {
  MeasuredRun run(rule(0.3), {{1.0, 1.0}, {1.2, 1.0}});
  run.remove("fb_1");
  run.remove("fb_2");
  run.tick();
  for (const char* metric : {"number", "mean_size", "largest"}) {
    EXPECT_EQ(run.metric(metric), 0.0) << metric;
  }
  run.simulation().reset();
  EXPECT_EQ(run.metric("largest"), 2.0);
}

TEST(RobotClustersTest, BetweenMeasurementsTheLastValuesStay) {
  MeasuredRun run(rule(0.3, "<every>3</every>"), {{1.0, 1.0}, {1.2, 1.0}});
  run.put("fb_2", {5.0, 1.0});
  run.tick(2);
  EXPECT_EQ(run.metric("number"), 1.0) << "of tick 0";
  run.tick();
  EXPECT_EQ(run.metric("number"), 2.0) << "of tick 3";
  run.put("fb_2", {1.2, 1.0});
  run.tick(2);
  EXPECT_EQ(run.metric("number"), 2.0);
}

/// By flood fill from each robot, over all pairs.
std::vector<std::size_t> sizesByLookingAtAll(const std::vector<Stand>& stands, double distance) {
  std::vector<char> is_seen(stands.size(), 0);
  std::vector<std::size_t> sizes;
  for (std::size_t first = 0; first < stands.size(); ++first) {
    std::vector<std::size_t> open;
    if (is_seen[first] == 0) {
      is_seen[first] = 1;
      open.push_back(first);
      sizes.push_back(0);
    }
    while (!open.empty()) {
      const Stand at = stands[open.back()];
      open.pop_back();
      ++sizes.back();
      for (std::size_t i = 0; i < stands.size(); ++i) {
        if (is_seen[i] == 0 && std::hypot(stands[i].x - at.x, stands[i].y - at.y) <= distance) {
          is_seen[i] = 1;
          open.push_back(i);
        }
      }
    }
  }
  return sizes;
}

TEST(RobotClustersTest, CountsWhatALookAtAllPairsCounts) {
  std::mt19937 random(20260411);
  std::uniform_real_distribution<double> place(0.0, 10.0);
  std::vector<Stand> stands(300);
  for (Stand& stand : stands) {
    stand = {place(random), place(random), 0.0};
  }
  for (const double distance : {0.11, 0.34, 0.57, 0.83, 2.9}) {
    const MeasuredRun run(rule(distance), stands);
    const std::vector<std::size_t> sizes = sizesByLookingAtAll(stands, distance);
    EXPECT_EQ(run.metric("number"), static_cast<double>(sizes.size())) << distance;
    EXPECT_EQ(run.metric("largest"), static_cast<double>(*std::max_element(sizes.begin(), sizes.end()))) << distance;
    EXPECT_EQ(run.metric("mean_size"), 300.0 / static_cast<double>(sizes.size())) << distance;
  }
}

TEST(RobotClustersTest, ASteadyTickAllocatesNothing) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  MeasuredRun run(rule(0.3), {{1.0, 1.0}, {1.2, 1.0}, {4.0, 1.0}});
  EXPECT_EQ(allocationsOfATick(run), 0);
}

}  // namespace
}  // namespace swarmanoid::test
