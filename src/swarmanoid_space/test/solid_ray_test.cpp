// Which of its own LEDs an entity hides, at places of LEDs as URDFs have them.
#include "swarmanoid_space/rays/solid_ray.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "swarmanoid_space/space.hpp"

namespace swarmanoid {
namespace {

using Eigen::Vector3d;

/// A box of 0.2 x 0.3 x 0.1 m around the body's origin.
class OwnLedTest : public testing::Test {
 protected:
  OwnLedTest() { addBox({0.1, 0.15, 0.05}); }

  void addBox(const Vector3d& half_extent, const Vector3d& position = Vector3d::Zero(), int joint = -1) {
    CollisionShape shape;
    shape.kind = CollisionShape::Kind::kBox;
    shape.half_extent = half_extent;
    shape.position = position;
    shape.joint = joint;
    model.shapes.push_back(shape);
  }

  /// Both in B.
  bool isSeen(const Vector3d& eye, const Vector3d& led) {
    model.led_positions = {Vector3d::Zero(), led};
    return hiddenLeds(model, joints, eye, LedSet("10")).none();
  }

  EntityModel model;
  std::vector<JointState> joints{JointState{}};
};

TEST_F(OwnLedTest, ALedOnAFaceIsSeenFromItsSide) {
  for (const double depth : {-0.01, -1e-12, 0.0, 1e-12, 0.003, 0.005}) {
    const Vector3d led(0.1 - depth, 0.02, 0.01);
    EXPECT_TRUE(isSeen({1.1, 0.3, -0.2}, led)) << depth << " m deep";
    EXPECT_FALSE(isSeen({-1.1, 0.3, -0.2}, led)) << depth << " m deep";
    EXPECT_FALSE(isSeen({-0.9, 1.4, 0.7}, led)) << depth << " m deep";
  }
}

TEST_F(OwnLedTest, ItStandsOutByHalfACentimetreAtTheMost) {
  // in the plane of its face the line to an eye goes down by `slope` per metre, over 0.13 m to the edge without skin
  const Vector3d led(0.1, 0.02, 0.01);
  const double most = 0.005 / (0.145 - 0.02);
  for (const double slope : {0.0, most - 0.001, most + 0.001, 0.2}) {
    EXPECT_EQ(isSeen({0.1 - 0.9 * slope, 0.92, 0.01}, led), slope < most) << "slope " << slope;
  }
}

TEST_F(OwnLedTest, ALedAtAnEdgeIsSeenFromBothSidesOfIt) {
  const Vector3d led(0.1, 0.02, 0.05);
  EXPECT_TRUE(isSeen({1.0, 0.2, -0.3}, led));
  EXPECT_TRUE(isSeen({-1.0, 0.2, 0.6}, led));
  EXPECT_TRUE(isSeen({0.0, 0.0, 2.0}, led));
  EXPECT_FALSE(isSeen({-1.0, 0.2, -0.3}, led));
}

TEST_F(OwnLedTest, AShapeInWhichItLiesDeepIsAHullThatHidesNothing) {
  const Vector3d led(0.1 - 0.0051, 0.02, 0.01);
  for (const Vector3d& eye : {Vector3d(1.1, 0.3, -0.2), Vector3d(-1.1, 0.3, -0.2), Vector3d(0.0, 0.0, -2.0)}) {
    EXPECT_TRUE(isSeen(eye, led));
  }
  addBox({0.02, 0.15, 0.15}, {-0.3, 0.0, 0.0});
  EXPECT_FALSE(isSeen({-1.1, 0.0, -0.1}, led)) << "but other shapes of the robot do";
  EXPECT_TRUE(isSeen({1.1, 0.0, -0.1}, led));
}

TEST_F(OwnLedTest, AThinPlateHidesToo) {
  addBox({0.2, 0.2, 0.001}, {0.0, 0.0, 0.2});
  const Vector3d led(0.05, -0.03, 0.201);
  EXPECT_TRUE(isSeen({0.4, 0.3, 0.9}, led));
  EXPECT_FALSE(isSeen({0.4, 0.3, -0.9}, led));
}

TEST_F(OwnLedTest, AnEyeInsideTheBodySeesNoLedOnItsSurface) {
  EXPECT_FALSE(isSeen({0.01, 0.02, 0.03}, {0.1, 0.02, 0.01}));
  EXPECT_TRUE(isSeen({0.098, 0.02, 0.03}, {0.1, 0.02, 0.01})) << "in the skin";
}

TEST_F(OwnLedTest, AnArmHidesWhereItsJointHasTurnedIt) {
  EntityModel::Joint shoulder;
  shoulder.name = "shoulder";
  shoulder.frame.position = {0.0, 0.0, 0.1};
  model.joints.push_back(shoulder);
  addBox({0.2, 0.02, 0.02}, {0.25, 0.0, 0.1}, 0);  // ahead of the joint, which turns it about z
  const Vector3d led(0.0, 0.0, 0.1);
  const double turned = 0.83;
  const Vector3d along(std::cos(turned), std::sin(turned), 0.0);
  EXPECT_FALSE(isSeen({0.9, 0.0, 0.1}, led));
  EXPECT_TRUE(isSeen(led + 0.9 * along, led));
  joints[0].angle = turned;
  EXPECT_TRUE(isSeen({0.9, 0.0, 0.1}, led));
  EXPECT_FALSE(isSeen(led + 0.9 * along, led));
}

TEST_F(OwnLedTest, AShapeThatIsTurnedHidesAsItStands) {
  model.shapes[0].orientation = Eigen::AngleAxisd(0.6, Vector3d::UnitZ());
  const Vector3d ahead(std::cos(0.6), std::sin(0.6), 0.0);
  const Vector3d left(-std::sin(0.6), std::cos(0.6), 0.0);
  EXPECT_TRUE(isSeen(0.9 * ahead + 0.1 * left, 0.1 * ahead + 0.02 * left));
  EXPECT_FALSE(isSeen(-0.9 * ahead + 0.1 * left, 0.1 * ahead + 0.02 * left));
  EXPECT_FALSE(isSeen({0.9, 0.0, 0.0}, -0.1 * ahead));
}

TEST_F(OwnLedTest, OnlyWhatIsAskedIsSaid) {
  model.led_positions = {{0.1, 0.0, 0.0}, {0.0, 0.15, 0.0}, {-0.1, 0.0, 0.0}};
  const Vector3d eye(1.0, 0.3, 0.0);
  EXPECT_EQ(hiddenLeds(model, joints, eye, LedSet("111")), LedSet("100"));
  EXPECT_EQ(hiddenLeds(model, joints, eye, LedSet("011")), LedSet());
}

TEST_F(OwnLedTest, NothingHidesALedWithoutABody) {
  model.shapes.clear();
  EXPECT_TRUE(isSeen({1.0, 1.0, 1.0}, Vector3d::Zero()));
  EXPECT_TRUE(isSeen(Vector3d::Zero(), Vector3d::Zero()));
}

}  // namespace
}  // namespace swarmanoid
