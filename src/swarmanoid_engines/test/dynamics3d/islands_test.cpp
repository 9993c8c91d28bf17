// Large islands are reported, and do not change the motion of other bodies.
#include <gtest/gtest.h>

#include <algorithm>

#include "world.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;

/// A footbot that pushes a block along, and, far away, footbots pressed into a corner.
struct PushBesideCrowd {
  explicit PushBesideCrowd(int side) {
    block = world.addBlock({0.2, 0.4, 0.2}, 1.3, flatPose(7.23, 8.0, 0.0, 0.1));
    const Row footbot = world.addFootbot(flatPose(7.0, 8.0));
    world.drive(footbot, 0.1);
    world.addBlock({0.1, 3.0, 0.4}, 0.0, flatPose(-0.05, 1.5, 0.0, 0.2));
    world.addBlock({3.0, 0.1, 0.4}, 0.0, flatPose(1.5, -0.05, 0.0, 0.2));
    for (int i = 0; i < side * side; ++i) {
      crowd.push_back(world.addFootbot(
          flatPose(0.12 + 0.2 * (i % side), 0.12 + 0.2 * (i / side), -0.75 * M_PI + 0.3 * std::sin(7.0 * i))));
      world.drive(crowd.back(), 0.2);
    }
  }

  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      world.step();
      reports +=
          static_cast<int>(std::count_if(world.space.events.begin(), world.space.events.end(),
                                         [](const Event& event) { return event.kind == Event::Kind::kEngineTrouble; }));
    }
  }

  World world;
  Row block = kNoRow;
  std::vector<Row> crowd;
  int reports = 0;
};

TEST(IslandsTest, ALargeCrowdIsReportedOnce) {
  PushBesideCrowd scene(5);
  scene.run(40);
  EXPECT_GT(scene.world.engine.solverCounts().large, 100U);
  EXPECT_EQ(scene.world.engine.solverCounts().iterative, 0U);
  EXPECT_EQ(scene.reports, 1);
  for (const Row row : scene.crowd) {
    const Pose& pose = scene.world.pose(row);
    EXPECT_GT(pose.position.head<2>().minCoeff(), 0.08);  // a footbot's radius, minus its lean on the wall
    EXPECT_NEAR(pose.position.z(), 0.0, 2e-3);
    EXPECT_LT(tiltOf(pose), 0.05);
    EXPECT_LT(scene.world.twist(row).linear.norm(), 0.3);
  }
}

TEST(IslandsTest, OthersMoveAsIfTheCrowdWereNotThere) {
  PushBesideCrowd scene(5);
  PushBesideCrowd alone(0);
  scene.run(30);
  alone.run(30);
  EXPECT_EQ(alone.world.engine.solverCounts().large, 0U);
  EXPECT_GT(alone.world.pose(alone.block).position.x(), 7.4);
  EXPECT_LT((scene.world.pose(scene.block).position - alone.world.pose(alone.block).position).norm(), 1e-6);
}

TEST(IslandsTest, TheSameRunGivesTheSameBits) {
  PushBesideCrowd first(5);
  PushBesideCrowd second(5);
  for (int i = 0; i < 15; ++i) {
    first.run(1);
    second.run(1);
    ASSERT_EQ(stateHash(first.world.space), stateHash(second.world.space)) << "tick " << i;
  }
}

}  // namespace
}  // namespace swarmanoid::dynamics3d
