#include "swarmanoid_space/ros/transforms.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "../small_world.hpp"

namespace swarmanoid {
namespace {

using Parents = std::map<std::string, std::string>;

/// Parent by child; fails the test for a child that has two.
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
