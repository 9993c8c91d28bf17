#include "planar/body_rays.hpp"

#include <algorithm>
#include <array>

#include "planar/planar_ray.hpp"
#include "swarmanoid_interface/expects.hpp"
#include "swarmanoid_interface/range.hpp"
#include "swarmanoid_space/rays/flat_rays.hpp"

namespace swarmanoid::planar {
namespace {

/// Some rays of a bundle in the plane's frame.
class PlanarRays {
 public:
  static constexpr std::size_t kMost = 32;

  bool isEmpty() const { return flat_.isEmpty(); }

  void assign(const Plane& plane, Span<const Segment> segments) {
    flat_.resize(segments.size());
    heights_ = {kInfinity, -kInfinity};
    for (std::size_t k = 0; k < segments.size(); ++k) {
      const Eigen::Vector2d from = plane.toLocal(segments[k].from);
      flat_.set(k, from, plane.toLocal(segments[k].to) - from);
      height_[k] = plane.along(segments[k].from);
      const double end = plane.along(segments[k].to);
      climb_[k] = end - height_[k];
      heights_.low = std::min({heights_.low, height_[k], end});
      heights_.high = std::max({heights_.high, height_[k], end});
    }
    flat_.measure();
  }

  /// Between which they all are.
  const Band& heights() const { return heights_; }
  const FlatRays<kMost>& flat() const { return flat_; }

  /// Ray k in the frame of a body.
  PlanarRay relativeTo(const PlacedPose& pose, std::size_t k) const {
    return {pose.unrotated(flat_.from(k) - pose.position), pose.unrotated(flat_.step(k)), height_[k], climb_[k]};
  }

 private:
  FlatRays<kMost> flat_;
  std::array<double, kMost> height_;
  std::array<double, kMost> climb_;
  Band heights_;
};

bool isVisibleTo(const RayBundle& rays, const Body& body) {
  return body.row != rays.ignored && body.row != rays.also_ignored && !body.is_seen_elsewhere;
}

/// Whether a shape of a body is as high as rays are.
bool isInReach(const PlanarShape& shape, const Body& body, double lowest, double highest) {
  return shape.band.low + body.along <= highest && lowest <= shape.band.high + body.along;
}

/// What of a body is as high as rays are: mostly one shape, since most rays are level.
struct ShapesInReach {
  const PlanarShape* first = nullptr;
  bool are_more = false;

  ShapesInReach(const Body& body, double lowest, double highest) {
    for (const PlanarShape& shape : body.model->shapes) {
      if (isInReach(shape, body, lowest, highest)) {
        are_more = first != nullptr;
        if (are_more) {
          return;
        }
        first = &shape;
      }
    }
  }

  bool isEmpty() const { return first == nullptr; }
  /// All of the body's if there are more than one.
  Span<const PlanarShape> list(const Body& body) const {
    return are_more ? Span<const PlanarShape>(body.model->shapes) : Span<const PlanarShape>(first, 1);
  }
};

/// Around a shape, in the plane's frame.
Bodies::Circle circleAround(const PlanarShape& shape, const Body& body) {
  return {body.pose.position + body.pose.rotated(shape.centre), shape.radius};
}

void hitShape(const Bodies& bodies, const PlanarRay& ray, const Body& body, const PlanarShape& shape, RayHit& hit) {
  const double fraction = closestHit(ray, shape, body.along);
  if (fraction > hit.fraction) {
    return;
  }
  // between surfaces at the same distance the older entity is hit, whatever the order of the look-up
  const BodyIndex rival = hit.row == kNoRow ? kNoBody : bodies.find(hit.row);
  if (fraction < hit.fraction || (rival != kNoBody && body.number < bodies[rival].number)) {
    hit = {fraction, body.row};
  }
}

/// @param hits of these rays
void hitBody(const Bodies& bodies, const PlanarRays& rays, BodyIndex index, Span<RayHit> hits) {
  const Body& body = bodies[index];
  const ShapesInReach shapes(body, rays.heights().low, rays.heights().high);
  if (shapes.isEmpty()) {
    return;
  }
  const Eigen::AlignedBox2d* wall = bodies.boundsOfWall(index);
  const Bodies::Circle circle = shapes.are_more ? bodies.circle(index) : circleAround(*shapes.first, body);
  const RayMask near =
      wall != nullptr ? rays.flat().nearBox(*wall) : rays.flat().nearPoint(circle.centre, circle.radius);
  visitRays(near, [&](std::size_t k) {
    const PlanarRay ray = rays.relativeTo(body.pose, k);
    for (const PlanarShape& shape : shapes.list(body)) {
      hitShape(bodies, ray, body, shape, hits[k]);
    }
  });
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
        found.add(Obstacles::Circle{{&engine, body.row, static_cast<int>(i)}, circle.centre, circle.radius});
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
  const Eigen::Vector2d centre = plane.toLocal(rays.centre);
  for (std::size_t first = 0; first < rays.segments.size(); first += PlanarRays::kMost) {
    const std::size_t count = std::min(PlanarRays::kMost, rays.segments.size() - first);
    PlanarRays planar_rays;
    bodies.visitNear(centre, rays.radius, [&](BodyIndex index) {
      if (isVisibleTo(rays, bodies[index])) {
        if (planar_rays.isEmpty()) {
          planar_rays.assign(plane, rays.segments.subspan(first, count));
        }
        hitBody(bodies, planar_rays, index, hits.subspan(first, count));
      }
      return true;
    });
  }
}

void raycastAt(const Bodies& bodies, const Obstacles::Solid& solid, Span<const Segment> segments, RayMask chosen,
               Span<RayHit> hits) {
  const BodyIndex index = bodies.find(solid.row);
  SWARMANOID_EXPECTS(index != kNoBody);
  const Plane& plane = bodies.plane();
  const Body& body = bodies[index];
  const std::vector<PlanarShape>& all = body.model->shapes;
  const Span<const PlanarShape> shapes = solid.part == Obstacles::kWhole
                                             ? Span<const PlanarShape>(all)
                                             : Span<const PlanarShape>(&all[static_cast<std::size_t>(solid.part)], 1);
  visitRays(chosen, [&](std::size_t k) {
    const Segment& segment = segments[k];
    const Eigen::Vector2d from = plane.toLocal(segment.from);
    const Eigen::Vector2d step = plane.toLocal(segment.to) - from;
    const double height = plane.along(segment.from);
    const PlanarRay ray{body.pose.unrotated(from - body.pose.position), body.pose.unrotated(step), height,
                        plane.along(segment.to) - height};
    for (const PlanarShape& shape : shapes) {
      hitShape(bodies, ray, body, shape, hits[k]);
    }
  });
}

bool isHit(const Bodies& bodies, const Segment& segment, BodyIndex index) {
  PlanarRays rays;
  rays.assign(bodies.plane(), Span<const Segment>(&segment, 1));
  const Body& body = bodies[index];
  const PlanarRay ray = rays.relativeTo(body.pose, 0);
  return std::any_of(body.model->shapes.begin(), body.model->shapes.end(),
                     [&](const PlanarShape& shape) { return closestHit(ray, shape, body.along) < 1.0; });
}

}  // namespace swarmanoid::planar
