// Loads that footbots push and pull, and their forces.
#include <gtest/gtest.h>

#include "world.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;

constexpr double kTraction = 0.9 * 1.8 * kGravity;  // N, limit of a footbot before its treels slip
constexpr double kFront = 0.11;                     // m, from a footbot's centre to its gripper's tip

/// A footbot at (2, 2) that drives against a block.
struct Push {
  explicit Push(double mass, int ticks = 60, const char* subclock = "10")
      : world({{"friction", "0.5"}, {"subclock", subclock}}) {
    footbot = world.addFootbot(flatPose(2.0, 2.0));
    block = world.addBlock({0.2, 0.4, 0.2}, mass, flatPose(2.0 + kFront + 0.01 + 0.1, 2.0, 0.0, 0.1));
    world.drive(footbot, 0.1);
    world.step(ticks);
  }
  double blockMoved() const { return world.pose(block).position.x() - (2.0 + kFront + 0.01 + 0.1); }

  World world;
  Row footbot = kNoRow;
  Row block = kNoRow;
};

TEST(PushingTest, ALightBlockIsPushedAtTheCommandedSpeed) {
  const Push push(1.0);
  EXPECT_NEAR(push.world.twist(push.footbot).linear.x(), 0.1, 1e-3);
  EXPECT_NEAR(push.world.twist(push.block).linear.x(), 0.1, 1e-3);
  EXPECT_GT(push.blockMoved(), 0.5);
}

TEST(PushingTest, TheSlipLimitIsTheFrictionOfTheTreels) {
  // the resistance is 0.5 of the block's weight
  const double limit = kTraction / (0.5 * kGravity);  // kg
  const Push below(0.95 * limit);
  EXPECT_GT(below.blockMoved(), 0.4);
  const Push above(1.05 * limit);
  EXPECT_LT(above.blockMoved(), 0.01);
  EXPECT_NEAR(above.world.twist(above.footbot).linear.x(), 0.0, 5e-3);
}

TEST(PushingTest, AFixedWallHoldsARobotThatSlipsOnTheSpot) {
  World world;
  const Row footbot = world.addFootbot(flatPose(2.0, 2.0));
  world.addBlock({0.1, 2.0, 0.5}, 0.0, flatPose(2.3, 2.0, 0.0, 0.25));
  world.drive(footbot, 0.3);
  world.step(100);
  const Pose& pose = world.pose(footbot);
  EXPECT_NEAR(pose.position.x(), 2.25 - kFront, 1e-3);
  EXPECT_LT(tiltOf(pose), 0.1);
  EXPECT_LT(world.twist(footbot).linear.norm(), 0.01);
}

TEST(PushingTest, TwoFootbotsPushMoreThanOne) {
  World world;
  const double mass = 1.5 * kTraction / (0.5 * kGravity);
  const Row block = world.addBlock({0.2, 0.6, 0.2}, mass, flatPose(2.3, 2.0, 0.0, 0.1));
  for (const double y : {1.85, 2.15}) {
    world.drive(world.addFootbot(flatPose(2.08, y)), 0.1);
  }
  world.step(50);
  EXPECT_GT(world.pose(block).position.x(), 2.6);
}

/// Robots side by side that push a block together.
struct Team {
  int robots;
  double share;    // friction of the block, as a share of the traction of all treels
  double heading;  // rad
};

void PrintTo(const Team& team, std::ostream* out) {
  *out << team.robots << " robots, " << team.share << " of their limit, heading " << team.heading;
}

class TeamTest : public testing::TestWithParam<Team> {};

TEST_P(TeamTest, PushesUpToTheSumOfItsTraction) {
  constexpr double kSpeed = 0.087;  // m/s
  constexpr double kApart = 0.2;    // m
  const auto [robots, share, heading] = GetParam();
  World world({{"friction", "0.5"}});
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(heading, Vector3d::UnitZ()));
  const auto at = [&](double ahead, double aside, double height) {
    return Pose{Vector3d(4.0, 5.0, height) + turn * Vector3d(ahead, aside, 0.0), turn};
  };
  const double mass = share * robots * kTraction / (0.5 * kGravity);
  const Row block = world.addBlock({0.2, kApart * robots, 0.2}, mass, at(kFront + 0.01 + 0.1, 0.0, 0.1));
  for (int i = 0; i < robots; ++i) {
    world.drive(world.addFootbot(at(0.0, kApart * (i - 0.5 * (robots - 1)), 0.0)), kSpeed);
  }
  world.step(20);
  const Vector3d before = world.pose(block).position;
  world.step(40);
  const double speed = (turn.conjugate() * (world.pose(block).position - before)).x() / 4.0;
  EXPECT_NEAR(speed, share < 1.0 ? kSpeed : 0.0, 3e-3);
}

INSTANTIATE_TEST_SUITE_P(Teams, TeamTest,
                         testing::Values(Team{3, 0.8, 0.4}, Team{3, 0.96, -1.3}, Team{3, 1.04, 2.2}, Team{5, 0.94, 2.9},
                                         Team{5, 1.06, 0.7}, Team{8, 0.96, -2.1}, Team{8, 1.04, 0.2},
                                         Team{12, 0.94, 1.1}, Team{12, 1.06, -0.6}, Team{12, 1.3, 0.0}));

TEST(PushingTest, ThePushedBodiesNeverSinkIntoEachOther) {
  for (const char* subclock : {"10", "50"}) {
    const Push push(1.0, 30, subclock);
    const double gap =
        push.world.pose(push.block).position.x() - push.world.pose(push.footbot).position.x() - kFront - 0.1;
    EXPECT_NEAR(gap, 0.0, 3e-4) << subclock;  // it leans on the block, which tilts it a little
  }
}

TEST(PushingTest, StandingFootbotsResistAsTheyAreBraked) {
  // without a command the treels do not turn; sideways they do not roll anyway
  World world;
  const Row pusher = world.addFootbot(flatPose(2.0, 2.0));
  world.addFootbot(flatPose(2.0 + kFront + 0.09, 2.0, M_PI / 2.0));
  const Row last = world.addFootbot(flatPose(2.0 + kFront + 0.09 + 0.18, 2.0, M_PI / 2.0));
  world.drive(pusher, 0.1);
  world.step(100);
  EXPECT_LT(world.pose(last).position.x() - (2.0 + kFront + 0.09 + 0.18), 0.002);
  EXPECT_LT(world.pose(pusher).position.x(), 2.01);
}

}  // namespace
}  // namespace swarmanoid::dynamics3d
