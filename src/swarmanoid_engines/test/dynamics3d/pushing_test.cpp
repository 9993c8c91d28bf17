// What footbots push and pull, and how hard.
#include <gtest/gtest.h>

#include "world.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;

constexpr double kTraction = 0.9 * 1.8 * kGravity;  // N, of a footbot whose treels do not slip yet
constexpr double kFront = 0.11;                     // m, from a footbot's centre to its gripper's tip

/// A footbot at (2, 2) that drives at a block.
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
  // what resists is 0.5 of the block's weight
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

TEST(PushingTest, ThePushedBodiesNeverSinkIntoEachOther) {
  for (const char* subclock : {"10", "50"}) {
    const Push push(1.0, 30, subclock);
    const double gap =
        push.world.pose(push.block).position.x() - push.world.pose(push.footbot).position.x() - kFront - 0.1;
    EXPECT_NEAR(gap, 0.0, 3e-4) << subclock;  // it leans on the block, which tilts it a little
  }
}

TEST(PushingTest, StandingFootbotsResistAsTheyAreBraked) {
  // without a command the treels do not turn; across, they do not roll anyway
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
