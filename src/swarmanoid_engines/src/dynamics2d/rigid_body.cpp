#include "dynamics2d/rigid_body.hpp"

#include <box2d/b2_fixture.h>

#include <algorithm>
#include <cmath>

namespace swarmanoid::dynamics2d {
namespace {

constexpr double kFloatUlp = 1.1920928955078125e-7;  // of 1, in single precision

/// What a coordinate changed by in a step: by velocity times time, without the rounding of adding a small number to a
/// large one; and by what Box2D moved it beyond that, as far as that is more than such rounding.
double change(float now, float before, double by_velocity) {
  const double beyond = static_cast<double>(now) - static_cast<double>(before) - by_velocity;
  const double rounding =
      kFloatUlp * std::max(std::abs(static_cast<double>(now)), std::abs(static_cast<double>(before)));
  return std::abs(beyond) <= rounding ? by_velocity : by_velocity + beyond;
}

void addPolygon(b2Body& body, b2FixtureDef& definition, const planar::PlanarShape& shape) {
  const std::vector<Eigen::Vector2d>& corners = shape.vertices;
  constexpr std::size_t kMost = b2_maxPolygonVertices;
  // a fan of pieces around corner 0; neighbours share an edge
  for (std::size_t first = 1; first + 1 < corners.size(); first += kMost - 2) {
    const std::size_t count = std::min(kMost - 1, corners.size() - first);
    std::array<b2Vec2, kMost> piece;
    piece[0] = toUnits(corners[0]);
    for (std::size_t i = 0; i < count; ++i) {
      piece[i + 1] = toUnits(corners[first + i]);
    }
    b2PolygonShape polygon;
    polygon.Set(piece.data(), static_cast<int32>(count + 1));
    definition.shape = &polygon;
    body.CreateFixture(&definition);
  }
}

}  // namespace

void RigidBody::writeTransform() {
  if (!isConnected()) {
    heading = planar::wrapAngle(heading);  // a rigid joint would take a whole turn for an error
  }
  body->SetTransform(toUnits(pose().position), static_cast<float>(heading));
  last_centre = body->GetWorldCenter();
  last_angle = body->GetAngle();
}

void RigidBody::readStep(double h) {
  const b2Vec2& now = body->GetWorldCenter();
  const float angle = body->GetAngle();
  const b2Vec2& velocity = body->GetLinearVelocity();
  centre.x() += change(now.x, last_centre.x, velocity.x * h) / kUnitsPerMetre;
  centre.y() += change(now.y, last_centre.y, velocity.y * h) / kUnitsPerMetre;
  heading += change(angle, last_angle, body->GetAngularVelocity() * h);
  last_centre = now;
  last_angle = angle;
  // The floats go their own way by rounding; before it matters to contacts they are set right.
  constexpr double kApart = 1e-5;  // m, rad
  const double coarse = 2.0 * kFloatUlp * std::max(std::abs(centre.x()), std::abs(centre.y()));
  const double apart = (centre - toMetres(now)).cwiseAbs().maxCoeff();
  if (apart > std::max(kApart, coarse) || std::abs(heading - static_cast<double>(angle)) > kApart ||
      (std::abs(heading) > 2.0 * M_PI && !isConnected())) {
    writeTransform();
  }
}

planar::PlacedPose RigidBody::pose() const {
  planar::PlacedPose pose = planar::PlacedPose::at(centre, planar::wrapAngle(heading));
  if (!arm.isZero(0.0)) {
    pose.position -= pose.rotated(arm);
  }
  return pose;
}

void setShape(const planar::PlanarShape& shape, b2CircleShape& circle) {
  circle.m_p = toUnits(shape.centre);
  circle.m_radius = toUnits(shape.radius);
}

void setShape(const planar::PlanarShape& shape, b2PolygonShape& polygon) {
  std::array<b2Vec2, b2_maxPolygonVertices> corners;
  std::transform(shape.vertices.begin(), shape.vertices.end(), corners.begin(),
                 [](const Eigen::Vector2d& corner) { return toUnits(corner); });
  polygon.Set(corners.data(), static_cast<int32>(shape.vertices.size()));
}

void turnFixtures(b2Body& body, const PlanarModel& model, const EntityModel& entity, int joint) {
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

void addFixtures(b2Body& body, const PlanarModel& model, float friction, float restitution) {
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
