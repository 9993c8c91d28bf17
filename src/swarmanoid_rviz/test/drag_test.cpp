#include "../src/drag.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace swarmanoid {
namespace {

/// A roll followed by a yaw, so that turns about W's z axis and about the body's z axis differ.
geometry_msgs::Pose poseOf(double yaw, double roll) {
  geometry_msgs::Pose pose;
  pose.position.x = 1.3;
  pose.position.y = -0.4;
  pose.position.z = 0.7;
  pose.orientation.w = std::cos(0.5 * yaw) * std::cos(0.5 * roll);
  pose.orientation.x = std::cos(0.5 * yaw) * std::sin(0.5 * roll);
  pose.orientation.y = std::sin(0.5 * yaw) * std::sin(0.5 * roll);
  pose.orientation.z = std::sin(0.5 * yaw) * std::cos(0.5 * roll);
  return pose;
}

void expectEqual(const geometry_msgs::Quaternion& expected, const geometry_msgs::Quaternion& q) {
  EXPECT_NEAR(1.0, std::abs(expected.x * q.x + expected.y * q.y + expected.z * q.z + expected.w * q.w), 1e-12);
}

TEST(DragTest, ItComesAlongAsItWasHeld) {
  const geometry_msgs::Pose start = poseOf(0.3, 0.2);
  Drag drag(start, 1.35, -0.42);
  EXPECT_DOUBLE_EQ(0.7, drag.height());
  EXPECT_FALSE(drag.isMove());
  drag.follow(9.0, 9.0, false);
  drag.follow(2.05, 0.28, false);
  EXPECT_NEAR(2.0, drag.pose().position.x, 1e-12);
  EXPECT_NEAR(0.3, drag.pose().position.y, 1e-12);
  EXPECT_DOUBLE_EQ(0.7, drag.pose().position.z);
  expectEqual(start.orientation, drag.pose().orientation);
  EXPECT_TRUE(drag.isMove());
  drag.follow(1.354, -0.416, false);
  EXPECT_FALSE(drag.isMove()) << "6 mm: a click";
}

TEST(DragTest, ItTurnsAboutTheVerticalUntilItFacesThePointer) {
  Drag drag(poseOf(0.3, 0.2), 1.35, -0.42);
  drag.follow(1.3 + 0.5 * std::cos(2.9), -0.4 + 0.5 * std::sin(2.9), true);
  expectEqual(poseOf(2.9, 0.2).orientation, drag.pose().orientation);
  EXPECT_DOUBLE_EQ(1.3, drag.pose().position.x);
  EXPECT_DOUBLE_EQ(-0.4, drag.pose().position.y);
  EXPECT_TRUE(drag.isMove());
  drag.follow(1.3 + 0.7 * std::cos(0.31), -0.4 + 0.7 * std::sin(0.31), true);
  EXPECT_FALSE(drag.isMove()) << "it faces that already";
  drag.follow(1.302, -0.401, true);
  EXPECT_FALSE(drag.isMove()) << "too close to say where";
  drag.follow(1.356, -0.417, true);
  EXPECT_FALSE(drag.isMove()) << "a hand that trembles";
}

TEST(DragTest, AFullTurnIsNone) {
  Drag drag(poseOf(3.14, 0.0), 1.5, 0.6);
  drag.follow(1.3 - 0.3 * std::cos(1e-3), -0.4 - 0.3 * std::sin(1e-3), true);
  EXPECT_FALSE(drag.isMove());
  drag.follow(1.3, -1.4, true);
  expectEqual(poseOf(-M_PI / 2, 0.0).orientation, drag.pose().orientation);
}

TEST(DragTest, WhatIsNotDraggedStaysAsItIsWhenItIsLetGo) {
  geometry_msgs::Pose now = poseOf(1.1, 0.0);  // the entity has moved meanwhile
  now.position.x = 1.6;
  now.position.y = -0.1;
  now.position.z = 0.75;
  Drag drag(poseOf(0.3, 0.0), 1.3, -0.4);
  drag.follow(2.3, -1.4, false);
  EXPECT_NEAR(2.3, drag.applyTo(now).position.x, 1e-12);
  EXPECT_NEAR(-1.4, drag.applyTo(now).position.y, 1e-12);
  EXPECT_DOUBLE_EQ(0.75, drag.applyTo(now).position.z);
  expectEqual(now.orientation, drag.applyTo(now).orientation);
  drag.follow(1.6, 0.9, true);
  EXPECT_DOUBLE_EQ(1.6, drag.applyTo(now).position.x);
  expectEqual(poseOf(M_PI / 2, 0.0).orientation, drag.applyTo(now).orientation);
}

}  // namespace
}  // namespace swarmanoid
