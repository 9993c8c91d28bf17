// LEDs that their own entity hides, with positions of LEDs as in URDFs.
#include "swarmanoid_space/rays/led_shades.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
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

  /// @param eye, led in B
  bool isSeen(const Vector3d& eye, const Vector3d& led) {
    model.led_positions = {Vector3d::Zero(), led};
    return hidden(eye, LedSet("10")).none();
  }
  LedSet hidden(const Vector3d& eye, const LedSet& asked) {
    model.measureShapes();
    LedShades shades;
    shades.begin(model, {joints.data(), joints.size()});
    return shades.hidden(eye, asked);
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
  // in the plane of the face the line to an eye falls by `slope` per metre, over 0.13 m to the edge without the skin
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
  EXPECT_EQ(hidden(eye, LedSet("111")), LedSet("100"));
  EXPECT_EQ(hidden(eye, LedSet("011")), LedSet());
}

/// Returns whether a sampled point of the line before the LED is in the cylinder, shrunk by the height of LEDs; nothing
/// if a point is closer to the surface than the step length.
std::optional<bool> isThroughCylinder(const CollisionShape& cylinder, const Vector3d& eye, const Vector3d& led) {
  constexpr int kSteps = 4000;
  const double radius = cylinder.half_extent.x() - kLedHeight;
  const double half_height = cylinder.half_extent.z() - kLedHeight;
  double deepest = -1.0;
  for (int i = 0; i <= kSteps; ++i) {
    const Vector3d point = cylinder.orientation.conjugate() * (eye + (led - eye) * i / kSteps - cylinder.position);
    deepest = std::max(deepest, std::min(radius - point.head<2>().norm(), half_height - std::abs(point.z())));
  }
  if (std::abs(deepest) < (led - eye).norm() / kSteps) {
    return std::nullopt;
  }
  return deepest > 0.0;
}

TEST_F(OwnLedTest, ACylinderHidesWhatItsInsideStandsBefore) {
  CollisionShape& cylinder = model.shapes[0];
  cylinder.kind = CollisionShape::Kind::kCylinder;
  std::mt19937_64 random(5);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  int seen = 0;
  int hidden_ones = 0;
  for (int i = 0; i < 600; ++i) {
    cylinder.half_extent = {0.085, 0.085, uniform(0.02, 0.1)};
    cylinder.position = {uniform(-0.05, 0.05), uniform(-0.05, 0.05), uniform(0.0, 0.1)};
    cylinder.orientation = Eigen::AngleAxisd(i % 2 == 0 ? 0.0 : uniform(-3.0, 3.0), Vector3d(0.6, 0.0, 0.8));
    const double angle = uniform(-3.1, 3.1);
    const double height = uniform(-1.3, 1.3) * cylinder.half_extent.z();
    const Vector3d led =
        cylinder.position + cylinder.orientation * Vector3d(0.084 * std::cos(angle), 0.084 * std::sin(angle), height);
    const Vector3d eye(uniform(-1.0, 1.0), uniform(-1.0, 1.0), uniform(-0.3, 0.5));
    const std::optional<bool> expected = isThroughCylinder(cylinder, eye, led);
    if (expected && std::abs(std::abs(height) - cylinder.half_extent.z()) > 0.01) {
      EXPECT_EQ(!isSeen(eye, led), *expected) << i;
      ++(*expected ? hidden_ones : seen);
    }
  }
  EXPECT_GT(seen, 150);
  EXPECT_GT(hidden_ones, 150);
}

TEST_F(OwnLedTest, NothingHidesALedWithoutABody) {
  model.shapes.clear();
  EXPECT_TRUE(isSeen({1.0, 1.0, 1.0}, Vector3d::Zero()));
  EXPECT_TRUE(isSeen(Vector3d::Zero(), Vector3d::Zero()));
}

}  // namespace
}  // namespace swarmanoid
