// Which of its own lamps an entity hides, at places of lamps as URDFs have them.
#include "swarmanoid_space/solid_ray.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "swarmanoid_space/space.hpp"

namespace swarmanoid {
namespace {

using Eigen::Vector3d;

/// A box of 0.2 x 0.3 x 0.1 m around the body's origin.
class OwnLampTest : public testing::Test {
 protected:
  OwnLampTest() { addBox({0.1, 0.15, 0.05}); }

  void addBox(const Vector3d& half_extent, const Vector3d& position = Vector3d::Zero(), int joint = -1) {
    CollisionShape shape;
    shape.kind = CollisionShape::Kind::kBox;
    shape.half_extent = half_extent;
    shape.position = position;
    shape.joint = joint;
    model.shapes.push_back(shape);
  }

  /// Both in B.
  bool isSeen(const Vector3d& eye, const Vector3d& lamp) {
    model.led_positions = {Vector3d::Zero(), lamp};
    return hiddenLamps(model, joints, eye, Lamps("10")).none();
  }

  EntityModel model;
  JointState joints[Space::kMaxJoints];
};

TEST_F(OwnLampTest, ALampOnAFaceIsSeenFromItsSide) {
  for (const double depth : {-0.01, -1e-12, 0.0, 1e-12, 0.003, 0.005}) {
    const Vector3d lamp(0.1 - depth, 0.02, 0.01);
    EXPECT_TRUE(isSeen({1.1, 0.3, -0.2}, lamp)) << depth << " m deep";
    EXPECT_FALSE(isSeen({-1.1, 0.3, -0.2}, lamp)) << depth << " m deep";
    EXPECT_FALSE(isSeen({-0.9, 1.4, 0.7}, lamp)) << depth << " m deep";
  }
}

TEST_F(OwnLampTest, ItStandsOutByHalfACentimetreAtTheMost) {
  // in the plane of its face the line to an eye goes down by `slope` per metre, over 0.13 m to the edge without skin
  const Vector3d lamp(0.1, 0.02, 0.01);
  const double most = 0.005 / (0.145 - 0.02);
  for (const double slope : {0.0, most - 0.001, most + 0.001, 0.2}) {
    EXPECT_EQ(isSeen({0.1 - 0.9 * slope, 0.92, 0.01}, lamp), slope < most) << "slope " << slope;
  }
}

TEST_F(OwnLampTest, ALampAtAnEdgeIsSeenFromBothSidesOfIt) {
  const Vector3d lamp(0.1, 0.02, 0.05);
  EXPECT_TRUE(isSeen({1.0, 0.2, -0.3}, lamp));
  EXPECT_TRUE(isSeen({-1.0, 0.2, 0.6}, lamp));
  EXPECT_TRUE(isSeen({0.0, 0.0, 2.0}, lamp));
  EXPECT_FALSE(isSeen({-1.0, 0.2, -0.3}, lamp));
}

TEST_F(OwnLampTest, AShapeInWhichItLiesDeepIsAHullThatHidesNothing) {
  const Vector3d lamp(0.1 - 0.0051, 0.02, 0.01);
  for (const Vector3d& eye : {Vector3d(1.1, 0.3, -0.2), Vector3d(-1.1, 0.3, -0.2), Vector3d(0.0, 0.0, -2.0)}) {
    EXPECT_TRUE(isSeen(eye, lamp));
  }
  addBox({0.02, 0.15, 0.15}, {-0.3, 0.0, 0.0});
  EXPECT_FALSE(isSeen({-1.1, 0.0, -0.1}, lamp)) << "but other shapes of the robot do";
  EXPECT_TRUE(isSeen({1.1, 0.0, -0.1}, lamp));
}

TEST_F(OwnLampTest, AThinPlateHidesToo) {
  addBox({0.2, 0.2, 0.001}, {0.0, 0.0, 0.2});
  const Vector3d lamp(0.05, -0.03, 0.201);
  EXPECT_TRUE(isSeen({0.4, 0.3, 0.9}, lamp));
  EXPECT_FALSE(isSeen({0.4, 0.3, -0.9}, lamp));
}

TEST_F(OwnLampTest, AnEyeInsideTheBodySeesNoLampOnItsSurface) {
  EXPECT_FALSE(isSeen({0.01, 0.02, 0.03}, {0.1, 0.02, 0.01}));
  EXPECT_TRUE(isSeen({0.098, 0.02, 0.03}, {0.1, 0.02, 0.01})) << "in the skin";
}

TEST_F(OwnLampTest, AnArmHidesWhereItsJointHasTurnedIt) {
  EntityModel::Joint shoulder;
  shoulder.name = "shoulder";
  shoulder.frame.position = {0.0, 0.0, 0.1};
  model.joints.push_back(shoulder);
  addBox({0.2, 0.02, 0.02}, {0.25, 0.0, 0.1}, 0);  // ahead of the joint, which turns it about z
  const Vector3d lamp(0.0, 0.0, 0.1);
  const double turned = 0.83;
  const Vector3d along(std::cos(turned), std::sin(turned), 0.0);
  EXPECT_FALSE(isSeen({0.9, 0.0, 0.1}, lamp));
  EXPECT_TRUE(isSeen(lamp + 0.9 * along, lamp));
  joints[0].angle = turned;
  EXPECT_TRUE(isSeen({0.9, 0.0, 0.1}, lamp));
  EXPECT_FALSE(isSeen(lamp + 0.9 * along, lamp));
}

TEST_F(OwnLampTest, AShapeThatIsTurnedHidesAsItStands) {
  model.shapes[0].orientation = Eigen::AngleAxisd(0.6, Vector3d::UnitZ());
  const Vector3d ahead(std::cos(0.6), std::sin(0.6), 0.0);
  const Vector3d left(-std::sin(0.6), std::cos(0.6), 0.0);
  EXPECT_TRUE(isSeen(0.9 * ahead + 0.1 * left, 0.1 * ahead + 0.02 * left));
  EXPECT_FALSE(isSeen(-0.9 * ahead + 0.1 * left, 0.1 * ahead + 0.02 * left));
  EXPECT_FALSE(isSeen({0.9, 0.0, 0.0}, -0.1 * ahead));
}

TEST_F(OwnLampTest, OnlyWhatIsAskedIsSaid) {
  model.led_positions = {{0.1, 0.0, 0.0}, {0.0, 0.15, 0.0}, {-0.1, 0.0, 0.0}};
  const Vector3d eye(1.0, 0.3, 0.0);
  EXPECT_EQ(hiddenLamps(model, joints, eye, Lamps("111")), Lamps("100"));
  EXPECT_EQ(hiddenLamps(model, joints, eye, Lamps("011")), Lamps());
}

TEST_F(OwnLampTest, NothingHidesALampWithoutABody) {
  model.shapes.clear();
  EXPECT_TRUE(isSeen({1.0, 1.0, 1.0}, Vector3d::Zero()));
  EXPECT_TRUE(isSeen(Vector3d::Zero(), Vector3d::Zero()));
}

}  // namespace
}  // namespace swarmanoid
