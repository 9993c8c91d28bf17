#include "planar/body_rays.hpp"

#include <algorithm>

#include "planar/planar_ray.hpp"
#include "swarmanoid_interface/expects.hpp"
#include "swarmanoid_interface/range.hpp"
#include "swarmanoid_space/rays/flat_rays.hpp"

namespace swarmanoid::planar {
namespace {

/// A segment in the frame of a body.
inline PlanarRay relativeTo(const Body& body, const Plane& plane, const Segment& segment) {
  const Eigen::Vector2d from = plane.toLocal(segment.from);
  const Eigen::Vector2d step = plane.toLocal(segment.to) - from;
  const double height = plane.along(segment.from);
  return {body.pose.unrotated(from - body.pose.position), body.pose.unrotated(step), height,
          plane.along(segment.to) - height};
}

/// Some rays of a bundle, projected to the plane, and the range of heights that holds all of them.
struct PlanarRays {
  static constexpr std::size_t kMost = 32;

  Span<const Segment> segments;
  FlatRays<kMost> flat;
  Band heights;

  void assign(const Plane& plane, Span<const Segment> some) {
    segments = some;
    flat.resize(some.size());
    heights = {kInfinity, -kInfinity};
    for (std::size_t k = 0; k < some.size(); ++k) {
      const Eigen::Vector2d from = plane.toLocal(some[k].from);
      flat.set(k, from, plane.toLocal(some[k].to) - from);
      const double start = plane.along(some[k].from);
      const double end = plane.along(some[k].to);
      heights.low = std::min({heights.low, start, end});
      heights.high = std::max({heights.high, start, end});
    }
    flat.measure();
  }
};

struct Disc {
  Eigen::Vector2d centre;
  double radius;  // m
};

/// A disc that holds all rays of a bundle, seen along the plane's normal.
Disc discAround(const Plane& plane, const RayBundle& rays) {
  if (rays.segments.size() != 1) {
    return {plane.toLocal(rays.centre), rays.radius};
  }
  // a single ray is often steep: it goes to the ground and is much shorter in the plane
  constexpr double kMargin = 1e-6;  // m, for rounding
  const Eigen::Vector2d from = plane.toLocal(rays.segments[0].from);
  const Eigen::Vector2d to = plane.toLocal(rays.segments[0].to);
  return {0.5 * (from + to), 0.5 * (to - from).norm() + kMargin};
}

bool isVisibleTo(const RayBundle& rays, const Body& body) {
  return body.row != rays.ignored && body.row != rays.also_ignored && !body.is_seen_elsewhere;
}

/// Whether the heights of a shape overlap those of the rays.
bool isInReach(const PlanarShape& shape, const Body& body, double lowest, double highest) {
  return shape.band.low + body.along <= highest && lowest <= shape.band.high + body.along;
}

/// Whether a shape is a circle that spans all heights of the rays, so that its outline decides every hit.
bool isCircleToAll(const PlanarShape& shape, const Body& body, const RayBundle& rays) {
  return shape.isCircle() && shape.band.low + body.along <= rays.lowest && rays.highest <= shape.band.high + body.along;
}

/// Circle around a shape, in the plane's frame.
Bodies::Circle circleAround(const PlanarShape& shape, const Body& body) {
  return {body.pose.position + body.pose.rotated(shape.centre), shape.radius};
}

void hitShape(const Bodies& bodies, const PlanarRay& ray, const Body& body, const PlanarShape& shape, RayHit& hit) {
  const double fraction = closestHit(ray, shape, body.along);
  if (fraction > hit.fraction) {
    return;
  }
  // of surfaces at the same distance, the older entity is hit, whatever the order of the query
  const BodyIndex rival = hit.row == kNoRow ? kNoBody : bodies.find(hit.row);
  if (fraction < hit.fraction || (rival != kNoBody && body.number < bodies[rival].number)) {
    hit = {fraction, body.row};
  }
}

/// @param hits of these rays
void hitBody(const Bodies& bodies, const PlanarRays& rays, BodyIndex index, Span<RayHit> hits) {
  const Body& body = bodies[index];
  const Eigen::AlignedBox2d* wall = bodies.boundsOfWall(index);
  for (const PlanarShape& shape : body.model->shapes) {
    if (!isInReach(shape, body, rays.heights.low, rays.heights.high)) {
      continue;
    }
    const Bodies::Circle circle = circleAround(shape, body);
    const RayMask near = wall != nullptr ? rays.flat.nearBox(*wall) : rays.flat.nearPoint(circle.centre, circle.radius);
    visitRays(near, [&](std::size_t k) {
      hitShape(bodies, relativeTo(body, bodies.plane(), rays.segments[k]), body, shape, hits[k]);
    });
  }
}

}  // namespace

bool mayHit(const Bodies& bodies, const RayBundle& rays) {
  bool may_hit = false;
  bodies.visitNear(bodies.plane().toLocal(rays.centre), rays.radius, [&](BodyIndex index) {
    may_hit = isVisibleTo(rays, bodies[index]);
    return !may_hit;
  });
  return may_hit;
}

void addObstacle(const Engine& engine, const Bodies& bodies, BodyIndex index, const RayBundle& rays,
                 const Eigen::Vector2d& middle, Obstacles& found) {
  if (bodies.isFartherThan(index, middle, rays.radius)) {
    return;
  }
  const Body& body = bodies[index];
  if (!isVisibleTo(rays, body)) {
    return;
  }
  if (const Eigen::AlignedBox2d* wall = bodies.boundsOfWall(index)) {
    if (wall->squaredExteriorDistance(middle) <= rays.radius * rays.radius) {
      found.add(Obstacles::Box{{&engine, body.row, Obstacles::kWhole}, wall->min(), wall->max()});
    }
    return;
  }
  const std::vector<PlanarShape>& shapes = body.model->shapes;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (isInReach(shapes[i], body, rays.lowest, rays.highest)) {
      const Bodies::Circle circle = circleAround(shapes[i], body);
      const double reach = rays.radius + circle.radius;
      if ((circle.centre - middle).squaredNorm() <= reach * reach) {
        found.add(Obstacles::Circle{{&engine, body.row, static_cast<int>(i)},
                                    circle.centre,
                                    circle.radius,
                                    isCircleToAll(shapes[i], body, rays)});
      }
    }
  }
}

void findObstacles(const Engine& engine, const Bodies& bodies, const RayBundle& rays, Obstacles& found) {
  const Eigen::Vector2d middle = bodies.plane().toLocal(rays.centre);
  bodies.visitNear(middle, rays.radius, [&](BodyIndex index) {
    addObstacle(engine, bodies, index, rays, middle, found);
    return !found.areAnywhere();
  });
}

void raycast(const Bodies& bodies, const RayBundle& rays, Span<RayHit> hits) {
  const Plane& plane = bodies.plane();
  const Disc around = discAround(plane, rays);
  for (std::size_t first = 0; first < rays.segments.size(); first += PlanarRays::kMost) {
    const std::size_t count = std::min(PlanarRays::kMost, rays.segments.size() - first);
    PlanarRays planar_rays;
    bodies.visitNear(around.centre, around.radius, [&](BodyIndex index) {
      if (isVisibleTo(rays, bodies[index])) {
        if (planar_rays.segments.empty()) {
          planar_rays.assign(plane, rays.segments.subspan(first, count));
        }
        hitBody(bodies, planar_rays, index, hits.subspan(first, count));
      }
      return true;
    });
  }
}

void castRayAt(const Bodies& bodies, const Obstacles::Solid& solid, const Segment& segment, RayHit& hit) {
  const BodyIndex index = bodies.find(solid.row);
  SWARMANOID_EXPECTS(index != kNoBody);
  const Body& body = bodies[index];
  const PlanarRay ray = relativeTo(body, bodies.plane(), segment);
  const std::vector<PlanarShape>& shapes = body.model->shapes;
  if (solid.part != Obstacles::kWhole) {
    hitShape(bodies, ray, body, shapes[static_cast<std::size_t>(solid.part)], hit);
    return;
  }
  for (const PlanarShape& shape : shapes) {
    hitShape(bodies, ray, body, shape, hit);
  }
}

bool isHit(const Bodies& bodies, const Segment& segment, BodyIndex index) {
  const Body& body = bodies[index];
  const PlanarRay ray = relativeTo(body, bodies.plane(), segment);
  return std::any_of(body.model->shapes.begin(), body.model->shapes.end(),
                     [&](const PlanarShape& shape) { return closestHit(ray, shape, body.along) < 1.0; });
}

}  // namespace swarmanoid::planar
