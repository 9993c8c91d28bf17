#include "swarmanoid_recording/messages/transforms.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_experiment_files/testing/small_world.hpp"
#include "swarmanoid_interface/devices/odometry.hpp"

namespace swarmanoid {
namespace {

using Parents = std::map<std::string, std::string>;

/// Returns the parents by child; fails the test for a child with two parents.
Parents parentsOf(const std::vector<tf2_msgs::TFMessage>& messages) {
  Parents parents;
  for (const auto& message : messages) {
    for (const auto& transform : message.transforms) {
      EXPECT_TRUE(parents.emplace(transform.child_frame_id, transform.header.frame_id).second)
          << transform.child_frame_id << " has two parents, or one twice";
    }
  }
  return parents;
}

TEST(TransformsTest, FullTreeReachesTheWorldAndHasNoLeadingSlash) {
  const auto simulation = test::smallWorld();
  simulation->start();
  Transforms transforms;
  const Parents parents = parentsOf({transforms.moving(simulation->space()), transforms.fixed(simulation->space())});
  EXPECT_EQ("world", parents.at("fb_1/base_link"));
  EXPECT_EQ("world", parents.at("prey/base_link"));
  EXPECT_EQ("world", parents.at("wall/base_link"));
  EXPECT_EQ("fb_1/base_link", parents.at("fb_1/left_wheel_link"));
  EXPECT_EQ("eb/base_link", parents.at("eb/camera"));
  for (auto [child, parent] : parents) {
    EXPECT_NE('/', child[0]);
    int steps = 0;
    for (; parent != "world" && steps < 10; ++steps) {
      ASSERT_EQ(1U, parents.count(parent)) << parent << " hangs in the air";
      parent = parents.at(parent);
    }
    EXPECT_LT(steps, 10) << child;
  }
}

TEST(TransformsTest, WhatMovesIsInOneBatchWithOneStamp) {
  const auto simulation = test::smallWorld();
  simulation->start();
  simulation->tick();
  Transforms transforms(TransformLevel::kBase);
  const tf2_msgs::TFMessage& moving = transforms.moving(simulation->space());
  ASSERT_EQ(4U, moving.transforms.size());  // the prey and three robots
  for (const auto& transform : moving.transforms) {
    EXPECT_EQ(ros::Time(1, 100000000), transform.header.stamp);
  }
  EXPECT_EQ(2U, transforms.fixed(simulation->space()).transforms.size());  // the block and the lamp
}

TEST(TransformsTest, TheGripperTurnsWithTheTurret) {
  Space space;
  const Row row = space.entities.add("fb", robotModel("footbot"), Pose{}, Color{});
  space.joints[row][0].angle = 0.5;
  Transforms transforms(TransformLevel::kFull);
  const tf2_msgs::TFMessage moving = transforms.moving(space);
  const tf2_msgs::TFMessage fixed = transforms.fixed(space);
  EXPECT_EQ(parentsOf({moving, fixed}).at("fb/turret"), "fb/base_link");
  EXPECT_EQ(parentsOf({moving, fixed}).at("fb/gripper_tip"), "fb/turret");
  for (const auto& transform : moving.transforms) {
    if (transform.child_frame_id == "fb/turret") {
      EXPECT_NEAR(transform.transform.rotation.z, std::sin(0.25), 1e-12);
      EXPECT_NEAR(transform.transform.rotation.w, std::cos(0.25), 1e-12);
      EXPECT_NEAR(transform.transform.translation.z, 0.05, 1e-12);
    }
  }
}

TEST(TransformsTest, WheelsTurnAsTheyHaveTurned) {
  Space space;
  const Row row = space.entities.add("fb", robotModel("footbot"), Pose{}, Color{});
  space.wheel_turns[row] = {0.8, -7.0};
  Transforms transforms(TransformLevel::kFull);
  int found = 0;
  for (const auto& transform : transforms.moving(space).transforms) {
    const bool is_left = transform.child_frame_id == "fb/left_wheel_link";
    if (is_left || transform.child_frame_id == "fb/right_wheel_link") {
      ++found;
      EXPECT_NEAR(transform.transform.rotation.y, std::sin(is_left ? 0.4 : M_PI - 3.5), 1e-12) << "-7 is 2 pi - 7";
    }
  }
  EXPECT_EQ(found, 2);
}

TEST(TransformsTest, OdometryIsBelowTheRobotOnRequest) {
  Space space;
  space.tick = 1;
  space.clocktick = std::chrono::milliseconds(100);
  space.time = kEpoch + space.clocktick;
  const Row row = space.entities.add("fb", robotModel("footbot"), Pose{}, Color{});
  space.entities.add("other", robotModel("footbot"), Pose{}, Color{});  // without odometry
  Odometry& odometry = space.readings.bank<Odometry>().add(row);
  odometry.x = 0.7;
  odometry.y = -0.4;
  odometry.heading = 1.1;
  EXPECT_EQ(2U, Transforms(TransformLevel::kBase).moving(space).transforms.size());
  Transforms shown(TransformLevel::kBase, OdometryFrames::kShown);
  const tf2_msgs::TFMessage& moving = shown.moving(space);
  ASSERT_EQ(3U, moving.transforms.size());
  EXPECT_EQ("fb/base_link", parentsOf({moving}).at("fb/odom")) << "base_link has the world for its parent";
  for (const auto& transform : moving.transforms) {
    if (transform.child_frame_id == "fb/odom") {
      // base_link in odom is at (0.7, -0.4), turned by 1.1 rad; this is the inverse
      EXPECT_NEAR(transform.transform.translation.x, -0.7 * std::cos(1.1) + 0.4 * std::sin(1.1), 1e-12);
      EXPECT_NEAR(transform.transform.translation.y, 0.7 * std::sin(1.1) + 0.4 * std::cos(1.1), 1e-12);
      EXPECT_NEAR(transform.transform.rotation.z, std::sin(-0.55), 1e-12);
      EXPECT_NEAR(transform.transform.rotation.w, std::cos(0.55), 1e-12);
    }
  }
}

/// A robot drives ahead from x = 0.3 with exact odometry, so `odom` stays at 0.3 in the world.
TEST(TransformsTest, OdometryHasTheStampOfTheStateThatWasRead) {
  Space space;
  space.clocktick = std::chrono::milliseconds(100);
  Pose start;
  start.position.x() = 0.3;
  const Row row = space.entities.add("fb", robotModel("footbot"), start, Color{});
  Odometry& odometry = space.readings.bank<Odometry>().add(row);
  Transforms shown(TransformLevel::kBase, OdometryFrames::kShown);
  std::map<ros::Time, double> place;  // of base_link, by stamp
  int found = 0;
  for (int tick = 0; tick < 4; ++tick) {
    space.tick = static_cast<std::uint64_t>(tick);
    space.time = kEpoch + tick * space.clocktick;
    space.entities.pose[row].position.x() = 0.3 + 0.07 * tick;
    odometry.x = tick == 0 ? 0.0 : 0.07 * (tick - 1);  // readings belong to the previous state
    for (const auto& transform : shown.moving(space).transforms) {
      if (transform.child_frame_id == "fb/base_link") {
        place[transform.header.stamp] = transform.transform.translation.x;
      } else {
        ++found;
        ASSERT_EQ(1U, place.count(transform.header.stamp)) << "tick " << tick;
        EXPECT_NEAR(0.3, place[transform.header.stamp] + transform.transform.translation.x, 1e-12) << "tick " << tick;
      }
    }
  }
  EXPECT_EQ(3, found) << "none before the robot is sensed";
}

TEST(TransformsTest, NoneIsNone) {
  const auto simulation = test::smallWorld();
  simulation->start();
  Transforms transforms(TransformLevel::kNone);
  EXPECT_TRUE(transforms.moving(simulation->space()).transforms.empty());
  EXPECT_TRUE(transforms.fixed(simulation->space()).transforms.empty());
}

TEST(TransformsTest, LevelsAreReadStrictly) {
  EXPECT_EQ(std::nullopt, parseTransformLevel("auto"));
  EXPECT_EQ(TransformLevel::kFull, parseTransformLevel("full"));
  EXPECT_THROW(parseTransformLevel("ful"), ConfigError);
}

}  // namespace
}  // namespace swarmanoid
