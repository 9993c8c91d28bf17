#include "planar/body_rays.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "planar/planar_ray.hpp"

namespace swarmanoid::planar {
namespace {

/// Some rays of a bundle in the plane's frame, column by column so that all are compared with a body at once.
class PlanarRays {
 public:
  static constexpr std::size_t kMost = 32;

  PlanarRays() {}  // the columns are left as they are: most bundles hit nothing
  bool isEmpty() const { return count_ == 0; }

  void assign(const Plane& plane, Span<const Segment> segments) {
    count_ = segments.size();
    for (std::size_t k = 0; k < count_; ++k) {
      const Eigen::Vector2d from = plane.toLocal(segments[k].from);
      const Eigen::Vector2d step = plane.toLocal(segments[k].to) - from;
      from_x_[k] = from.x();
      from_y_[k] = from.y();
      step_x_[k] = step.x();
      step_y_[k] = step.y();
      height_[k] = plane.along(segments[k].from);
      climb_[k] = plane.along(segments[k].to) - height_[k];
    }
    for (std::size_t k = 0; k < count_; ++k) {
      const double length_squared = step_x_[k] * step_x_[k] + step_y_[k] * step_y_[k];
      length_[k] = std::sqrt(length_squared);
      half_length_squared_[k] = 0.5 * length_squared;
    }
  }

  /// Finds the rays that come near a point, seen from above: within the radius to their side, and as far before or
  /// behind them. @return how many; they stand in `near()`
  std::size_t findNear(const Eigen::Vector2d& point, double radius) {
    // without branches and divisions, so that the compiler works on several rays at once: all is scaled by the length
    const double x = point.x();
    const double y = point.y();
    for (std::size_t k = 0; k < count_; ++k) {
      const double way_x = x - from_x_[k];
      const double way_y = y - from_y_[k];
      const double across = std::abs(way_x * step_y_[k] - way_y * step_x_[k]);
      const double along = std::abs(way_x * step_x_[k] + way_y * step_y_[k] - half_length_squared_[k]);
      const double beyond = along - half_length_squared_[k];
      excess_[k] = (across > beyond ? across : beyond) - radius * length_[k];
    }
    std::size_t found = 0;
    for (std::size_t k = 0; k < count_; ++k) {
      near_[found] = static_cast<unsigned char>(k);
      found += excess_[k] <= 0.0 ? 1 : 0;
    }
    return found;
  }
  const unsigned char* near() const { return near_.data(); }

  /// Ray k in the frame of a body.
  PlanarRay relativeTo(const PlacedPose& pose, std::size_t k) const {
    const double way_x = from_x_[k] - pose.position.x();
    const double way_y = from_y_[k] - pose.position.y();
    PlanarRay ray;
    ray.from = {pose.cosine * way_x + pose.sine * way_y, pose.cosine * way_y - pose.sine * way_x};
    ray.step = {pose.cosine * step_x_[k] + pose.sine * step_y_[k], pose.cosine * step_y_[k] - pose.sine * step_x_[k]};
    ray.height = height_[k];
    ray.climb = climb_[k];
    return ray;
  }

 private:
  using Column = std::array<double, kMost>;
  std::size_t count_ = 0;
  Column from_x_;
  Column from_y_;
  Column step_x_;
  Column step_y_;
  Column length_;
  Column half_length_squared_;
  Column height_;
  Column climb_;
  Column excess_;
  std::array<unsigned char, kMost> near_;
};

bool isVisibleTo(const RayBundle& rays, const Body& body) {
  return body.row != rays.ignored && body.row != rays.also_ignored && !body.is_seen_elsewhere;
}

void hitBody(const Bodies& bodies, const PlanarRay& ray, const Body& body, RayHit& hit) {
  for (const PlanarShape& shape : body.model->shapes) {
    const double fraction = closestHit(ray, shape, body.along);
    if (fraction > hit.fraction) {
      continue;
    }
    // between surfaces at the same distance the older entity is hit, whatever the order of the look-up
    const BodyIndex rival = hit.row == kNoRow ? kNoBody : bodies.find(hit.row);
    if (fraction < hit.fraction || (rival != kNoBody && body.number < bodies[rival].number)) {
      hit = {fraction, body.row};
    }
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

void raycast(const Bodies& bodies, const RayBundle& rays, Span<RayHit> hits) {
  const Plane& plane = bodies.plane();
  const Eigen::Vector2d centre = plane.toLocal(rays.centre);
  for (std::size_t first = 0; first < rays.segments.size(); first += PlanarRays::kMost) {
    const std::size_t count = std::min(PlanarRays::kMost, rays.segments.size() - first);
    PlanarRays planar_rays;
    bodies.visitNear(centre, rays.radius, [&](BodyIndex index) {
      const Body& body = bodies[index];
      if (!isVisibleTo(rays, body)) {
        return true;
      }
      if (planar_rays.isEmpty()) {
        planar_rays.assign(plane, rays.segments.subspan(first, count));
      }
      const std::size_t near = planar_rays.findNear(body.pose.position, body.model->radius);
      for (std::size_t i = 0; i < near; ++i) {
        const std::size_t k = planar_rays.near()[i];
        hitBody(bodies, planar_rays.relativeTo(body.pose, k), body, hits[first + k]);
      }
      return true;
    });
  }
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
