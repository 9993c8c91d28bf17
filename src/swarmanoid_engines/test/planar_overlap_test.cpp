#include "planar/planar_overlap.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

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

/// A polygon of 3 to 8 corners on an ellipse with half axes from 0.2 to 1, turned at random.
PlanarShape anyPolygon(std::mt19937& random) {
  std::uniform_real_distribution<double> part(0.0, 1.0);
  std::array<double, 8> angles;
  const std::size_t count = 3 + random() % 6;
  std::generate_n(angles.begin(), count, [&] { return 2.0 * M_PI * part(random); });
  std::sort(angles.begin(), angles.begin() + count);
  const Vector2d half_axes(0.2 + 0.8 * part(random), 0.2 + 0.8 * part(random));
  const Eigen::Rotation2Dd turn(2.0 * M_PI * part(random));
  PlanarShape shape;
  shape.radius = 1.0;
  for (std::size_t i = 0; i < count; ++i) {
    shape.vertices.push_back(turn * Vector2d(half_axes.x() * std::cos(angles[i]), half_axes.y() * std::sin(angles[i])));
  }
  return shape;
}

/// Distance to the nearest of many points along the outline: at most 2 / kPoints^2 / distance too large.
double distanceToOutline(const PlanarShape& polygon, const Vector2d& point) {
  constexpr int kPoints = 4000;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
    const Vector2d& from = polygon.vertices[i];
    const Vector2d& to = polygon.vertices[(i + 1) % polygon.vertices.size()];
    for (int k = 0; k <= kPoints; ++k) {
      nearest = std::min(nearest, (from + k * (to - from) / kPoints - point).norm());
    }
  }
  return nearest;
}

/// Whether the outline goes around a point, by the angles at which its corners are seen from there.
bool isInside(const PlanarShape& polygon, const Vector2d& point) {
  double turns = 0.0;
  for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
    const Vector2d a = polygon.vertices[i] - point;
    const Vector2d b = polygon.vertices[(i + 1) % polygon.vertices.size()] - point;
    turns += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)) / (2.0 * M_PI);
  }
  return turns > 0.5;
}

/// Overlap does not depend on the order of shapes.
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

TEST(PlanarOverlapTest, CirclesAnywhereAtPolygonsOfAnyForm) {
  constexpr double kNearly = 1e-4;  // m: more than the error of the distance to the outline
  std::mt19937 random(20261128);
  std::uniform_real_distribution<double> coordinate(-1.2, 1.2);
  std::array<int, 3> cases{};
  for (int i = 0; i < 600; ++i) {
    const PlanarShape polygon = anyPolygon(random);
    const Vector2d centre(coordinate(random), coordinate(random));
    const double distance = distanceToOutline(polygon, centre);
    const bool is_inside = isInside(polygon, centre);
    ++cases[is_inside ? 0 : distance < 0.4 ? 1 : 2];
    if (distance > 0.02) {  // for smaller distances, the points are too far apart
      EXPECT_EQ(areOverlapping(circle(centre, distance - kNearly), polygon), is_inside) << "polygon " << i;
    }
    EXPECT_TRUE(areOverlapping(circle(centre, distance + kNearly), polygon)) << "polygon " << i;
    const double depth = penetration(circle(centre, distance + kNearly), polygon).depth;
    EXPECT_NEAR(depth, kNearly + (is_inside ? 2.0 * distance : 0.0), kNearly) << "polygon " << i;
  }
  for (const int count : cases) {
    EXPECT_GT(count, 40);
  }
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
