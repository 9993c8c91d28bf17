#include "planar/planar_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "world.hpp"

namespace swarmanoid::planar {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector2d;
using Eigen::Vector3d;

PlanarModel projected(const EntityModel& entity, const Plane& plane, const Quaterniond& base) {
  PlanarModel model;
  projectModel(entity, plane, base, model);
  return model;
}

EntityModel modelOf(CollisionShape::Kind kind, const Vector3d& half_extent, const Vector3d& position = Vector3d::Zero(),
                    const Quaterniond& orientation = Quaterniond::Identity()) {
  EntityModel model;
  model.shapes.push_back({kind, half_extent, position, orientation});
  return model;
}

Eigen::AlignedBox2d boundsOf(const PlanarShape& shape) {
  Eigen::AlignedBox2d bounds;
  for (const Vector2d& vertex : shape.vertices) {
    bounds.extend(vertex);
  }
  return bounds;
}

/// Twice the area; positive for counter-clockwise vertices.
double twiceArea(const PlanarShape& shape) {
  double sum = 0.0;
  for (std::size_t i = 0; i < shape.vertices.size(); ++i) {
    const Vector2d& a = shape.vertices[i];
    const Vector2d& b = shape.vertices[(i + 1) % shape.vertices.size()];
    sum += a.x() * b.y() - a.y() * b.x();
  }
  return sum;
}

TEST(PlanarModelTest, AFootbotIsThreeCirclesAndASquare) {
  const PlanarModel model = projected(*footbotModel(), Plane('z', 0.0), Quaterniond::Identity());
  ASSERT_EQ(model.shapes.size(), 4U);
  EXPECT_TRUE(model.shapes[0].isCircle());
  EXPECT_EQ(model.shapes[0].radius, 0.085);
  EXPECT_NEAR(model.shapes[0].band.low, 0.01, 1e-12);
  EXPECT_NEAR(model.shapes[0].band.high, 0.146, 1e-12);
  EXPECT_EQ(model.shapes[1].centre, Vector2d(0.0, 0.07));
  ASSERT_EQ(model.shapes[3].vertices.size(), 4U);
  EXPECT_NEAR(twiceArea(model.shapes[3]), 2.0 * 0.04 * 0.04, 1e-12);
  EXPECT_NEAR(model.radius, std::hypot(0.11, 0.02), 1e-12);  // the gripper's corner
  EXPECT_NEAR(model.band.low, 0.0, 1e-12);
  EXPECT_NEAR(model.band.high, 0.146, 1e-12);
}

TEST(PlanarModelTest, ABoxOnItsSideShowsItsOtherFaces) {
  const EntityModel box = modelOf(CollisionShape::Kind::kBox, {1.0, 2.0, 3.0});
  const Plane plane('z', 0.0);
  const PlanarShape upright = projected(box, plane, Quaterniond::Identity()).shapes[0];
  EXPECT_TRUE(boundsOf(upright).isApprox(Eigen::AlignedBox2d(Vector2d(-1.0, -2.0), Vector2d(1.0, 2.0))));
  const PlanarShape lying = projected(box, plane, Quaterniond(AngleAxisd(M_PI / 2.0, Vector3d::UnitY()))).shapes[0];
  EXPECT_EQ(lying.vertices.size(), 4U);
  EXPECT_TRUE(boundsOf(lying).isApprox(Eigen::AlignedBox2d(Vector2d(-3.0, -2.0), Vector2d(3.0, 2.0))));
  EXPECT_NEAR(lying.band.high, 1.0, 1e-12);
  EXPECT_GT(twiceArea(lying), 0.0);
}

TEST(PlanarModelTest, ABoxOnItsCornerIsAHexagon) {
  const EntityModel cube = modelOf(CollisionShape::Kind::kBox, {0.5, 0.5, 0.5});
  const Quaterniond on_corner = Quaterniond::FromTwoVectors(Vector3d::Ones(), Vector3d::UnitZ());
  const PlanarShape shape = projected(cube, Plane('z', 0.0), on_corner).shapes[0];
  EXPECT_EQ(shape.vertices.size(), 6U);
  EXPECT_NEAR(twiceArea(shape), 2.0 * std::sqrt(3.0), 1e-9);  // the largest shadow of a unit cube
  EXPECT_NEAR(shape.band.high, std::sqrt(3.0) / 2.0, 1e-12);
}

TEST(PlanarModelTest, CylindersAreCirclesFromAboveAndRectanglesFromTheSide) {
  const EntityModel cylinder = modelOf(CollisionShape::Kind::kCylinder, {0.2, 0.2, 0.5}, {0.1, 0.0, 0.5});
  const PlanarShape upright = projected(cylinder, Plane('z', 0.0), Quaterniond::Identity()).shapes[0];
  EXPECT_TRUE(upright.isCircle());
  EXPECT_EQ(upright.centre, Vector2d(0.1, 0.0));
  // in the plane of y and z it is seen from the side: u = y, v = z
  const PlanarShape side = projected(cylinder, Plane('x', 0.0), Quaterniond::Identity()).shapes[0];
  EXPECT_TRUE(boundsOf(side).isApprox(Eigen::AlignedBox2d(Vector2d(-0.2, 0.0), Vector2d(0.2, 1.0))));
  EXPECT_EQ(side.vertices.size(), 4U);
  EXPECT_NEAR(side.band.low, -0.1, 1e-12);
  EXPECT_NEAR(side.band.high, 0.3, 1e-12);
}

TEST(PlanarModelTest, SpheresAreCirclesFromEverywhere) {
  const EntityModel sphere = modelOf(CollisionShape::Kind::kSphere, {0.3, 0.3, 0.3}, {0.0, 0.0, 0.4});
  for (const char axis : {'x', 'y', 'z'}) {
    const PlanarModel model = projected(sphere, Plane(axis, 0.0), Quaterniond::Identity());
    EXPECT_TRUE(model.shapes[0].isCircle());
    EXPECT_EQ(model.shapes[0].radius, 0.3);
    EXPECT_NEAR(model.radius, axis == 'z' ? 0.3 : 0.7, 1e-12);
  }
}

TEST(PlanarModelTest, AxesSayWhereTheBodyIsAheadInThePlane) {
  const Plane wall('x', 0.0);
  const Quaterniond feet_on_wall(AngleAxisd(M_PI / 2.0, Vector3d::UnitY()));  // body z along W's x
  const PlanarModel model = projected(*footbotModel(), wall, feet_on_wall);
  EXPECT_TRUE(model.ahead.isApprox(Vector2d(0.0, -1.0)));  // down the wall
  EXPECT_TRUE(model.left.isApprox(Vector2d(1.0, 0.0)));
  EXPECT_NEAR(model.turn, 1.0, 1e-12);
  EXPECT_TRUE(model.shapes[0].isCircle());
}

TEST(PlanarModelTest, BandsThatTouchDoNotMeet) {
  const Band table{0.7, 0.1 + 0.2 + 0.45};
  EXPECT_FALSE(table.overlaps({0.0, 0.2}, 0.0, 0.75));
  EXPECT_TRUE(table.overlaps({0.0, 0.2}, 0.0, 0.74));
  EXPECT_FALSE(table.overlaps({0.0, 0.15}, 0.0, 0.0));
}

TEST(PlanarModelTest, PlacedShapesTurnAndShift) {
  const PlanarModel model = projected(*footbotModel(), Plane('z', 0.0), Quaterniond::Identity());
  std::vector<PlanarShape> placed;
  placeShapes(model, {1.0, 2.0}, 0.0, 1.0, placed);
  EXPECT_TRUE(placed[1].centre.isApprox(Vector2d(0.93, 2.0)));
  EXPECT_TRUE(boundsOf(placed[3]).isApprox(Eigen::AlignedBox2d(Vector2d(0.98, 2.07), Vector2d(1.02, 2.11))));
}

}  // namespace
}  // namespace swarmanoid::planar
