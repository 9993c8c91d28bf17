// The rules `swarm_order` and `square_displacement`: their metrics for robots at given poses and after given motions.
#include "measured_run.hpp"

namespace swarmanoid::test {
namespace {

constexpr double kMotionTolerance = 1e-12;
constexpr const char* kOrder = "<swarm_order id='r'><robots>fb_</robots></swarm_order>";
constexpr const char* kDisplacement = "<square_displacement id='r'><robots>fb_</robots></square_displacement>";

/// Robots on a circle, each rotated by the same angle relative to the outward direction.
std::vector<Stand> ring(int count, double against_outwards) {
  std::vector<Stand> stands;
  for (int i = 0; i < count; ++i) {
    const double angle = 0.37 + 2.0 * M_PI * i / count;
    stands.push_back({4.3 + 1.9 * std::cos(angle), 5.1 + 1.9 * std::sin(angle), angle + against_outwards});
  }
  return stands;
}

TEST(SwarmOrderTest, HeadingsAlikeAreFullyPolarised) {
  const double heading = 2.23;
  const MeasuredRun run(kOrder, {{1.2, 0.7, heading}, {4.1, 2.8, heading}, {8.9, 7.3, heading}});
  EXPECT_NEAR(run.metric("polarisation"), 1.0, kMotionTolerance) << "before the first tick, too";
}

TEST(SwarmOrderTest, PolarisationIsTheLengthOfTheMeanHeading) {
  const MeasuredRun run(kOrder, {{1.2, 0.7, 0.4}, {4.1, 2.8, 1.7}, {8.9, 7.3, -2.6}});
  const double east = std::cos(0.4) + std::cos(1.7) + std::cos(2.6);
  const double north = std::sin(0.4) + std::sin(1.7) - std::sin(2.6);
  EXPECT_NEAR(run.metric("polarisation"), std::hypot(east, north) / 3.0, kMotionTolerance);
}

/// On a ring the lever is the sine of the angle to the outward direction, for any number of robots.
TEST(SwarmOrderTest, AngularOrderIsTheSineOfTheAngleAgainstOutwards) {
  for (const double angle : {0.0, 0.61, M_PI / 2.0, -1.13, 2.9}) {
    const MeasuredRun run(kOrder, ring(7, angle));
    EXPECT_NEAR(run.metric("angular_order"), std::abs(std::sin(angle)), kMotionTolerance) << angle;
    EXPECT_NEAR(run.metric("polarisation"), 0.0, kMotionTolerance) << angle;
  }
}

TEST(SwarmOrderTest, WhoStandsAtTheCentroidTurnsAroundNothing) {
  const MeasuredRun run(kOrder, {{3.0, 2.0, 0.9}});
  EXPECT_EQ(run.metric("angular_order"), 0.0);
  EXPECT_NEAR(run.metric("polarisation"), 1.0, kMotionTolerance);
}

TEST(SwarmOrderTest, WithoutRobotsThereIsNone) {
  const MeasuredRun run(kOrder, {});
  EXPECT_EQ(run.metric("polarisation"), 0.0);
  EXPECT_EQ(run.metric("angular_order"), 0.0);
}

TEST(SquareDisplacementTest, IsTheMeanSquareOfTheWaysAsTheCrowFlies) {
  MeasuredRun run(kDisplacement, {{1.2, 0.7}, {4.1, 2.8}, {8.9, 7.3}});
  EXPECT_EQ(run.metric("mean_square"), 0.0) << "nobody has moved yet";
  EXPECT_EQ(run.metric("diffusivity"), 0.0);
  run.put("fb_1", {1.5, 1.1});
  run.tick();
  run.put("fb_1", {1.0, 0.9});  // the path in between does not count
  run.put("fb_2", {5.4, 0.3});
  run.tick();
  const double first = 0.2 * 0.2 + 0.2 * 0.2;
  const double second = 1.3 * 1.3 + 2.5 * 2.5;
  EXPECT_NEAR(run.metric("mean_square"), (first + second) / 3.0, kMotionTolerance);
  EXPECT_NEAR(run.metric("farthest"), std::sqrt(second), kMotionTolerance);
  EXPECT_NEAR(run.metric("diffusivity"), (first + second) / 3.0 / (4.0 * 0.2), kMotionTolerance);
  run.simulation().reset();
  EXPECT_EQ(run.metric("mean_square"), 0.0);
}

TEST(SquareDisplacementTest, WhoComesLaterBeginsThere) {
  MeasuredRun run(kDisplacement, {{1.2, 0.7}, {4.1, 2.8}});
  run.put("fb_2", {4.8, 2.8});
  run.tick(3);
  run.spawn("fb_9", {7.0, 7.0});
  run.tick();
  EXPECT_NEAR(run.metric("mean_square"), 0.7 * 0.7 / 3.0, kMotionTolerance);
  run.put("fb_9", {7.0, 6.6});
  run.remove("fb_1");
  run.tick();
  EXPECT_NEAR(run.metric("mean_square"), (0.7 * 0.7 + 0.4 * 0.4) / 2.0, kMotionTolerance);
  EXPECT_NEAR(run.metric("diffusivity"), (0.7 * 0.7 + 0.4 * 0.4) / (4.0 * (0.5 + 0.1)), kMotionTolerance)
      << "fb_2 is measured for 0.5 s, fb_9 for 0.1 s";
}

TEST(SwarmMotionTest, ASteadyTickAllocatesNothing) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  for (const char* rule : {kOrder, kDisplacement}) {
    MeasuredRun run(rule, {{1.0, 1.0}, {1.3, 1.0}, {4.0, 1.0}});
    EXPECT_EQ(allocationsOfATick(run), 0) << rule;
  }
}

}  // namespace
}  // namespace swarmanoid::test
