// The rule `contact_count`: robots that touch each other, walls and preys, at arbitrary positions and angles.
#include "measured_run.hpp"

namespace swarmanoid::test {
namespace {

constexpr double kRadius = 0.085;  // m, of a footbot
constexpr const char* kRule = "<contact_count id='r'><robots>fb_</robots></contact_count>";

/// Behind another robot, facing away from it, so that neither gripper is in between.
Stand behind(const Stand& stand, double distance) {
  return {stand.x - distance * std::cos(stand.heading), stand.y - distance * std::sin(stand.heading),
          stand.heading + M_PI};
}

std::string block(const std::string& id, const Eigen::Vector2d& centre, double degrees, const std::string& size) {
  return "<block id='" + id + "'><position>" + numberText(centre.x()) + "," + numberText(centre.y()) +
         ",0.25</position><orientation>0,0," + numberText(degrees) + "</orientation><size>" + size + "</size></block>";
}

TEST(ContactCountTest, TwoTouchUpToTheGapAndNoFarther) {
  const Stand one{3.1, 2.7, 0.73};
  for (const auto& [gap, touching] : {std::pair(0.0009, 1.0), std::pair(0.0011, 0.0)}) {
    const MeasuredRun run(kRule, {one, behind(one, 2.0 * kRadius + gap)});
    EXPECT_EQ(run.metric("robot_pairs"), touching) << gap;
    EXPECT_EQ(run.metric("touching"), 2.0 * touching) << gap;
    EXPECT_EQ(run.metric("object_pairs"), 0.0) << gap;
  }
}

/// The gripper reaches 0.11 m ahead. It touches a robot at that distance straight ahead, but not one at the side.
TEST(ContactCountTest, AGripperTouchesWhatIsAheadOnly) {
  const Stand one{3.1, 2.7, 0.73};
  const double distance = 0.11 + kRadius + 0.0005;
  const auto at = [&](double bearing) {
    const double way = one.heading + bearing;
    return Stand{one.x + distance * std::cos(way), one.y + distance * std::sin(way), way};  // its back to the other
  };
  EXPECT_EQ(MeasuredRun(kRule, {one, at(0.0)}).metric("robot_pairs"), 1.0);
  EXPECT_EQ(MeasuredRun(kRule, {one, at(1.3)}).metric("robot_pairs"), 0.0);
}

/// A wall of 3 m x 0.2 m at an oblique angle: robots beside it, at a corner, and apart from it.
TEST(ContactCountTest, WallsThatStandAskewAreTouchedWhereTheyAre) {
  const double turn = 0.61;  // rad
  const Eigen::Vector2d along(std::cos(turn), std::sin(turn));
  const Eigen::Vector2d across(-along.y(), along.x());
  const Eigen::Vector2d centre(5.2, 4.9);
  const auto at = [&](double way, double beside) {
    const Eigen::Vector2d place = centre + way * along + beside * across;
    return Stand{place.x(), place.y(), std::atan2(beside, way)};  // its back to the wall
  };
  const std::string wall = block("wall", centre, turn * 180.0 / M_PI, "3, 0.2, 0.5");
  const double diagonal = (kRadius + 0.0005) / std::sqrt(2.0);
  EXPECT_EQ(MeasuredRun(kRule, {at(0.83, 0.1 + kRadius + 0.0005)}, wall).metric("object_pairs"), 1.0);
  EXPECT_EQ(MeasuredRun(kRule, {at(-1.2, 0.1 + kRadius + 0.0015)}, wall).metric("object_pairs"), 0.0);
  EXPECT_EQ(MeasuredRun(kRule, {at(1.5 + diagonal, 0.1 + diagonal)}, wall).metric("object_pairs"), 1.0);
  EXPECT_EQ(MeasuredRun(kRule, {at(1.5 + 1.03 * diagonal, 0.1 + 1.03 * diagonal)}, wall).metric("object_pairs"), 0.0);
}

TEST(ContactCountTest, WhatIsOverARobotOrUnderItDoesNotTouchIt) {
  const std::string above =
      "<block id='above'><position>3, 3, 0.7</position><orientation>0,0,0</orientation><size>1, 1, 0.1</size></block>";
  EXPECT_EQ(MeasuredRun(kRule, {{3.0, 3.0}}, above).metric("object_pairs"), 0.0);
}

TEST(ContactCountTest, CollisionsAreCountedAsTheyBeginAndTimesAreSummed) {
  const Stand one{3.1, 2.7, 0.73};
  MeasuredRun run(kRule, {one, {6.0, 6.0}, {8.0, 2.0}, {2.0, 8.0}});
  EXPECT_EQ(run.metric("collisions"), 0.0);
  for (int time = 0; time < 2; ++time) {
    run.put("fb_2", behind(one, 2.0 * kRadius));
    run.tick(3);
    run.put("fb_2", {6.0, 6.0});
    run.tick(2);
  }
  EXPECT_EQ(run.metric("collisions"), 4.0) << "two robots, twice";
  EXPECT_NEAR(run.metric("time"), 2.0 * 3.0 * 0.1 * 2.0 / 4.0, 1e-12) << "two of four, for 0.6 s";
  EXPECT_EQ(run.metric("touching"), 0.0);
}

TEST(ContactCountTest, RobotsOfOthersCountAsWhatIsTouched) {
  const Stand beside{9.3 - 2.0 * kRadius * std::cos(1.1), 9.1 - 2.0 * kRadius * std::sin(1.1), 1.1 + M_PI};
  const MeasuredRun run(kRule, {beside});  // behind the robot `other`
  EXPECT_EQ(run.metric("robot_pairs"), 1.0);
  EXPECT_EQ(run.metric("touching"), 1.0);
}

TEST(ContactCountTest, ASteadyTickAllocatesNothing) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  const Stand one{3.1, 2.7, 0.73};
  MeasuredRun run(kRule, {one, behind(one, 2.0 * kRadius)}, block("wall", {5.0, 5.0}, 20.0, "3, 0.2, 0.5"));
  EXPECT_EQ(allocationsOfATick(run), 0);
}

}  // namespace
}  // namespace swarmanoid::test
