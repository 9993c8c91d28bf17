#include "dynamics2d/solver/contact_patch.hpp"

#include <box2d/b2_circle_shape.h>
#include <box2d/b2_collision.h>

#include <cmath>
#include <utility>

namespace swarmanoid::dynamics2d {
namespace {

b2Vec2 toFloat(const Eigen::Vector2d& v) { return {static_cast<float>(v.x()), static_cast<float>(v.y())}; }

/// Pose of `b` in the frame of `a`.
b2Transform relativePose(const planar::PlacedPose& a, const planar::PlacedPose& b) {
  b2Transform relative;
  relative.p = toFloat(a.unrotated(b.position - a.position));
  relative.q.c = static_cast<float>(a.cosine * b.cosine + a.sine * b.sine);
  relative.q.s = static_cast<float>(a.cosine * b.sine - a.sine * b.cosine);
  return relative;
}

/// The side whose normal is nearest to Box2D's separating normal.
int sideAlong(const ContactShape& shape, const b2Vec2& normal) {
  int best = 0;
  for (int i = 1; i < shape.count; ++i) {
    if (b2Dot(shape.polygon.m_normals[i], normal) > b2Dot(shape.polygon.m_normals[best], normal)) {
      best = i;
    }
  }
  return best;
}

const Eigen::Vector2d& corner(const ContactShape& shape, int i) {
  return shape.corners[static_cast<std::size_t>(i % shape.count)];
}

/// The polygon belongs to body a of the patch, the circle to body b.
ContactPatch polygonAndCircle(const ContactShape& polygon, const planar::PlacedPose& polygon_pose,
                              const ContactShape& circle, const planar::PlacedPose& circle_pose, double margin) {
  ContactPatch patch;
  b2PolygonShape single = polygon.polygon;
  single.m_radius = static_cast<float>(margin);
  b2CircleShape disc;
  disc.m_p = toFloat(circle.centre);
  disc.m_radius = static_cast<float>(circle.radius);
  b2Transform origin;
  origin.SetIdentity();
  b2Manifold manifold;
  manifold.pointCount = 0;
  b2CollidePolygonAndCircle(&manifold, &single, origin, &disc, relativePose(polygon_pose, circle_pose));
  if (manifold.pointCount == 0) {
    return patch;
  }
  patch.count = 1;
  patch.radius_b = circle.radius;
  FacingPoints& point = patch.points[0];
  point.on_b = circle.centre;
  for (int i = 0; i < polygon.count; ++i) {
    if (manifold.localPoint == polygon.polygon.m_vertices[i]) {
      point.on_a = corner(polygon, i);
      point.key = static_cast<std::uint32_t>(i);
      return patch;
    }
  }
  const int side = sideAlong(polygon, manifold.localNormal);
  patch.kind = ContactPatch::Kind::kSideOfA;
  patch.side = polygon.normals[static_cast<std::size_t>(side)];
  point.on_a = corner(polygon, side);
  point.key = static_cast<std::uint32_t>(16 + side);
  // the point of the side that faces the centre of the circle
  const Eigen::Vector2d middle =
      polygon_pose.unrotated(circle_pose.position + circle_pose.rotated(circle.centre) - polygon_pose.position);
  const Eigen::Vector2d along(-patch.side.y(), patch.side.x());
  point.on_a += along.dot(middle - point.on_a) * along;
  return patch;
}

/// A polygon of a pair, with the current pose of its body and the pose that Box2D uses.
struct PlacedPolygon {
  const ContactShape& shape;
  const planar::PlacedPose& pose;
  const b2Transform& single;
};

/// The side that faces another polygon's side most, by the same arithmetic as in Box2D.
int incidentSide(const PlacedPolygon& reference, int side, const PlacedPolygon& incident) {
  const b2Vec2 normal = b2MulT(incident.single.q, b2Mul(reference.single.q, reference.shape.polygon.m_normals[side]));
  int best = 0;
  float least = b2_maxFloat;
  for (int i = 0; i < incident.shape.count; ++i) {
    const float dot = b2Dot(normal, incident.shape.polygon.m_normals[i]);
    if (dot < least) {
      best = i;
      least = dot;
    }
  }
  return best;
}

/// Intersection of the line through a side with the line `along . (p - end) = 0`; the side's start if they are
/// parallel.
Eigen::Vector2d cutAt(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Eigen::Vector2d& end,
                      const Eigen::Vector2d& along) {
  constexpr double kParallel = 1e-12;  // m
  const double change = along.dot(to - from);
  return std::abs(change) > kParallel ? Eigen::Vector2d(from - along.dot(from - end) / change * (to - from)) : from;
}

/// Recomputes a pair of points in double precision: a corner of `incident`, or its side cut at a corner of `reference`;
/// and the point of the reference's side that faces it.
void placeOnSide(const PlacedPolygon& reference, int side, const PlacedPolygon& incident, b2ContactFeature feature,
                 Eigen::Vector2d& on_reference, Eigen::Vector2d& on_incident) {
  const Eigen::Vector2d& normal = reference.shape.normals[static_cast<std::size_t>(side)];
  const Eigen::Vector2d along(-normal.y(), normal.x());
  if (feature.typeB == b2ContactFeature::e_vertex) {
    on_incident = corner(incident.shape, feature.indexB);
  } else {
    const Eigen::Vector2d end =
        reference.pose.position + reference.pose.rotated(corner(reference.shape, feature.indexA));
    const int cut = incidentSide(reference, side, incident);
    on_incident = cutAt(corner(incident.shape, cut), corner(incident.shape, cut + 1),
                        incident.pose.unrotated(end - incident.pose.position),
                        incident.pose.unrotated(reference.pose.rotated(along)));
  }
  const Eigen::Vector2d there =
      reference.pose.unrotated(incident.pose.position + incident.pose.rotated(on_incident) - reference.pose.position);
  const Eigen::Vector2d& start = corner(reference.shape, side);
  on_reference = start + along.dot(there - start) * along;
}

b2ContactFeature swapped(const b2ContactFeature& feature) {
  return {feature.indexB, feature.indexA, feature.typeB, feature.typeA};
}

ContactPatch polygonAndPolygon(const ContactShape& shape_a, const planar::PlacedPose& a, const ContactShape& shape_b,
                               const planar::PlacedPose& b, double margin) {
  ContactPatch patch;
  b2PolygonShape single_a = shape_a.polygon;
  single_a.m_radius = static_cast<float>(margin);
  b2Transform origin;
  origin.SetIdentity();
  b2Manifold manifold;
  manifold.pointCount = 0;
  const b2Transform relative = relativePose(a, b);
  b2CollidePolygons(&manifold, &single_a, origin, &shape_b.polygon, relative);
  patch.count = manifold.pointCount;
  if (patch.count == 0) {
    return patch;
  }
  const PlacedPolygon placed_a{shape_a, a, origin};
  const PlacedPolygon placed_b{shape_b, b, relative};
  const bool is_b = manifold.type == b2Manifold::e_faceB;
  const int side = sideAlong(is_b ? shape_b : shape_a, manifold.localNormal);
  patch.kind = is_b ? ContactPatch::Kind::kSideOfB : ContactPatch::Kind::kSideOfA;
  patch.side = (is_b ? shape_b : shape_a).normals[static_cast<std::size_t>(side)];
  for (int i = 0; i < patch.count; ++i) {
    FacingPoints& point = patch.points[static_cast<std::size_t>(i)];
    const b2ContactID& id = manifold.points[i].id;
    point.key = id.key;
    if (is_b) {
      placeOnSide(placed_b, side, placed_a, swapped(id.cf), point.on_b, point.on_a);
    } else {
      placeOnSide(placed_a, side, placed_b, id.cf, point.on_a, point.on_b);
    }
  }
  return patch;
}

}  // namespace

ContactPatch findPatch(const ContactShape& shape_a, const planar::PlacedPose& a, const ContactShape& shape_b,
                       const planar::PlacedPose& b, double margin) {
  ContactPatch patch;
  const Eigen::Vector2d between = b.position + b.rotated(shape_b.centre) - a.position - a.rotated(shape_a.centre);
  const double reach = shape_a.radius + shape_b.radius + margin;
  if (between.squaredNorm() > reach * reach) {
    return patch;
  }
  if (shape_a.is_circle && shape_b.is_circle) {
    patch.count = 1;
    patch.radius_a = shape_a.radius;
    patch.radius_b = shape_b.radius;
    patch.points[0].on_a = shape_a.centre;
    patch.points[0].on_b = shape_b.centre;
    return patch;
  }
  if (!shape_a.is_circle && !shape_b.is_circle) {
    return polygonAndPolygon(shape_a, a, shape_b, b, margin);
  }
  if (!shape_a.is_circle) {
    return polygonAndCircle(shape_a, a, shape_b, b, margin);
  }
  patch = polygonAndCircle(shape_b, b, shape_a, a, margin);
  std::swap(patch.radius_a, patch.radius_b);
  std::swap(patch.points[0].on_a, patch.points[0].on_b);
  if (patch.kind == ContactPatch::Kind::kSideOfA) {
    patch.kind = ContactPatch::Kind::kSideOfB;
  }
  return patch;
}

}  // namespace swarmanoid::dynamics2d
