#include "planar/planar_overlap.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace swarmanoid::planar {
namespace {

using Eigen::Vector2d;

PlanarShape circle(const Vector2d& centre, double radius) {
  PlanarShape shape;
  shape.centre = centre;
  shape.radius = radius;
  return shape;
}

/// A square of half width 1, turned.
PlanarShape square(const Vector2d& centre, double angle = 0.0) {
  PlanarShape shape;
  shape.centre = centre;
  shape.radius = std::sqrt(2.0);
  for (int i = 0; i < 4; ++i) {
    const double corner = angle + M_PI / 4.0 + i * M_PI / 2.0;
    shape.vertices.push_back(centre + std::sqrt(2.0) * Vector2d(std::cos(corner), std::sin(corner)));
  }
  return shape;
}

/// Overlap does not depend on who is asked.
bool areOverlapping(const PlanarShape& a, const PlanarShape& b) {
  EXPECT_EQ(overlap(a, b), overlap(b, a));
  return overlap(a, b);
}

constexpr double kDeep = 1e-6;   // m: clearly beyond the tolerance
constexpr double kNear = 1e-10;  // m: within it

TEST(PlanarOverlapTest, Circles) {
  EXPECT_FALSE(areOverlapping(circle({0.0, 0.0}, 0.5), circle({0.6, 0.8}, 0.5)));
  EXPECT_FALSE(areOverlapping(circle({0.0, 0.0}, 0.5), circle({1.0 - kNear, 0.0}, 0.5)));
  EXPECT_TRUE(areOverlapping(circle({0.0, 0.0}, 0.5), circle({1.0 - kDeep, 0.0}, 0.5)));
  EXPECT_TRUE(areOverlapping(circle({0.0, 0.0}, 0.5), circle({0.0, 0.0}, 0.1)));
}

TEST(PlanarOverlapTest, CircleAtASide) {
  EXPECT_FALSE(areOverlapping(circle({1.5, 0.3}, 0.5), square({0.0, 0.0})));
  EXPECT_FALSE(areOverlapping(circle({1.5 - kNear, 0.3}, 0.5), square({0.0, 0.0})));
  EXPECT_TRUE(areOverlapping(circle({1.5 - kDeep, 0.3}, 0.5), square({0.0, 0.0})));
}

TEST(PlanarOverlapTest, CircleAtACorner) {
  // the corner is at (1, 1); the circle's centre 0.5 away, along (0.6, 0.8)
  EXPECT_FALSE(areOverlapping(circle({1.3, 1.4}, 0.5), square({0.0, 0.0})));
  EXPECT_TRUE(areOverlapping(circle({1.3 - kDeep, 1.4}, 0.5), square({0.0, 0.0})));
  // the bounding boxes meet, the shapes do not
  EXPECT_FALSE(areOverlapping(circle({1.4, 1.4}, 0.5), square({0.0, 0.0})));
}

TEST(PlanarOverlapTest, CircleInsideAndAround) {
  EXPECT_TRUE(areOverlapping(circle({0.2, 0.1}, 0.1), square({0.0, 0.0})));
  EXPECT_TRUE(areOverlapping(circle({0.2, 0.1}, 5.0), square({0.0, 0.0})));
}

TEST(PlanarOverlapTest, SquaresSideBySide) {
  EXPECT_FALSE(areOverlapping(square({0.0, 0.0}), square({2.0, 0.7})));
  EXPECT_FALSE(areOverlapping(square({0.0, 0.0}), square({2.0 - kNear, 0.7})));
  EXPECT_TRUE(areOverlapping(square({0.0, 0.0}), square({2.0 - kDeep, 0.7})));
  EXPECT_FALSE(areOverlapping(square({0.0, 0.0}), square({2.0, 2.0})));
}

TEST(PlanarOverlapTest, ADiamondPointsAtASide) {
  // its corner reaches sqrt(2) from its centre
  const double touching = 1.0 + std::sqrt(2.0);
  EXPECT_FALSE(areOverlapping(square({0.0, 0.0}), square({touching, 0.4}, M_PI / 4.0)));
  EXPECT_TRUE(areOverlapping(square({0.0, 0.0}), square({touching - kDeep, 0.4}, M_PI / 4.0)));
}

TEST(PlanarOverlapTest, ADiamondPassesACornerThatItsBoxWouldHit) {
  // the diamond's side runs along x + y = const, 1 from its centre; the corner (1, 1) is on it at centre 1 + 1/sqrt(2)
  const double touching = 1.0 + 1.0 / std::sqrt(2.0);
  EXPECT_FALSE(areOverlapping(square({0.0, 0.0}), square({touching, touching}, M_PI / 4.0)));
  EXPECT_TRUE(areOverlapping(square({0.0, 0.0}), square({touching - kDeep, touching - kDeep}, M_PI / 4.0)));
}

TEST(PlanarOverlapTest, ASmallPolygonInsideALargeOne) {
  PlanarShape small = square({0.0, 0.0}, 0.3);
  for (Vector2d& vertex : small.vertices) {
    vertex = 0.1 * vertex + Vector2d(0.5, 0.5);
  }
  small.centre = {0.5, 0.5};
  small.radius *= 0.1;
  EXPECT_TRUE(areOverlapping(small, square({0.0, 0.0})));
}

}  // namespace
}  // namespace swarmanoid::planar
