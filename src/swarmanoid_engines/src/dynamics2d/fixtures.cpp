#include "dynamics2d/fixtures.hpp"

#include <box2d/b2_fixture.h>

#include <algorithm>
#include <array>

#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid::dynamics2d {
namespace {

/// Between a polygon's sides and those that Box2D is given, around which it puts its skin [m].
constexpr double kInset = kSkin - kWidening;
static_assert(kInset < 0.4 * kThinnest, "the thinnest shape keeps an inside");

/// Of a convex polygon. Those of projected shapes have at most 32, and one more while one is cut off.
struct Corners {
  std::array<Eigen::Vector2d, 34> at;
  std::size_t count = 0;

  void add(const Eigen::Vector2d& corner) { at[count++] = corner; }
};

/// The part of a convex polygon to the left of a line through `from`.
Corners partLeftOf(const Corners& polygon, const Eigen::Vector2d& from, const Eigen::Vector2d& along) {
  Corners part;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Eigen::Vector2d& a = polygon.at[i];
    const Eigen::Vector2d& b = polygon.at[(i + 1) % polygon.count];
    const double left_a = planar::cross(along, a - from);
    const double left_b = planar::cross(along, b - from);
    if (left_a >= 0.0) {
      part.add(a);
    }
    if ((left_a > 0.0 && left_b < 0.0) || (left_a < 0.0 && left_b > 0.0)) {
      part.add(a + left_a / (left_a - left_b) * (b - a));
    }
  }
  return part;
}

/// A convex polygon whose sides are farther in.
Corners inset(const std::vector<Eigen::Vector2d>& corners) {
  Corners inner;
  for (const Eigen::Vector2d& corner : corners) {
    inner.add(corner);
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d along = (corners[(i + 1) % corners.size()] - corners[i]).normalized();
    inner = partLeftOf(inner, corners[i] + kInset * Eigen::Vector2d(-along.y(), along.x()), along);
  }
  return inner;
}

void addPolygon(b2Body& body, b2FixtureDef& definition, const planar::PlanarShape& shape) {
  const Corners corners = inset(shape.vertices);
  constexpr std::size_t kMost = b2_maxPolygonVertices;
  // a fan of pieces around corner 0; neighbours share an edge
  for (std::size_t first = 1; first + 1 < corners.count; first += kMost - 2) {
    const std::size_t count = std::min(kMost - 1, corners.count - first);
    std::array<b2Vec2, kMost> piece;
    piece[0] = toUnits(corners.at[0]);
    for (std::size_t i = 0; i < count; ++i) {
      piece[i + 1] = toUnits(corners.at[first + i]);
    }
    b2PolygonShape polygon;
    polygon.Set(piece.data(), static_cast<int32>(count + 1));
    definition.shape = &polygon;
    body.CreateFixture(&definition);
  }
}

}  // namespace

void setShape(const planar::PlanarShape& shape, b2CircleShape& circle) {
  SWARMANOID_EXPECTS(shape.isCircle());
  circle.m_p = toUnits(shape.centre);
  circle.m_radius = toUnits(shape.radius + kWidening);
}

void setShape(const planar::PlanarShape& shape, b2PolygonShape& polygon) {
  SWARMANOID_EXPECTS(!shape.isCircle());
  const Corners inner = inset(shape.vertices);
  SWARMANOID_EXPECTS(inner.count <= b2_maxPolygonVertices);
  std::array<b2Vec2, b2_maxPolygonVertices> corners;
  std::transform(inner.at.begin(), inner.at.begin() + static_cast<std::ptrdiff_t>(inner.count), corners.begin(),
                 [](const Eigen::Vector2d& corner) { return toUnits(corner); });
  polygon.Set(corners.data(), static_cast<int32>(inner.count));
}

void turnFixtures(b2Body& body, const planar::PlanarModel& model, const EntityModel& entity, int joint) {
  for (b2Fixture* fixture = body.GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext()) {
    const std::size_t i = fixture->GetUserData().pointer;
    if (entity.shapes[i].joint != joint) {
      continue;
    }
    const planar::PlanarShape& shape = model.shapes[i];
    if (shape.isCircle()) {
      setShape(shape, *static_cast<b2CircleShape*>(fixture->GetShape()));
    } else {
      setShape(shape, *static_cast<b2PolygonShape*>(fixture->GetShape()));
    }
  }
}

void addFixtures(b2Body& body, const planar::PlanarModel& model, float friction, float restitution) {
  constexpr double kSlowestBounce = 0.01;  // m/s
  for (std::size_t i = 0; i < model.shapes.size(); ++i) {
    const planar::PlanarShape& shape = model.shapes[i];
    b2FixtureDef definition;
    definition.friction = friction;
    definition.restitution = restitution;
    definition.restitutionThreshold = toUnits(kSlowestBounce);
    definition.userData.pointer = i;
    if (!shape.isCircle()) {
      addPolygon(body, definition, shape);
      continue;
    }
    b2CircleShape circle;
    setShape(shape, circle);
    definition.shape = &circle;
    body.CreateFixture(&definition);
  }
}

}  // namespace swarmanoid::dynamics2d
