// Rays against the shapes at their poses after the last tick.
#include "dynamics3d/dynamics3d.hpp"
#include "swarmanoid_interface/expects.hpp"
#include "swarmanoid_space/rays/solid_ray.hpp"

namespace swarmanoid::dynamics3d {
namespace {

bool isVisibleTo(const RayBundle& rays, const Body& body) {
  return body.row != rays.ignored && body.row != rays.also_ignored && !body.is_seen_elsewhere;
}

Eigen::AlignedBox3d boxAround(const RayBundle& rays) {
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(rays.radius);
  return {rays.centre - reach, rays.centre + reach};
}

}  // namespace

bool Dynamics3d::mayHit(const RayBundle& rays) const {
  bool may_hit = false;
  seen_.visitNear(boxAround(rays), [&](const Body* body, const Eigen::AlignedBox3d& bounds) {
    may_hit = isVisibleTo(rays, *body) && bounds.squaredExteriorDistance(rays.centre) <= rays.radius * rays.radius;
    return !may_hit;
  });
  return may_hit;
}

void Dynamics3d::raycast(const RayBundle& rays, Span<RayHit> hits) const {
  seen_.visitNear(boxAround(rays), [&](const Body* body, const Eigen::AlignedBox3d& bounds) {
    if (!isVisibleTo(rays, *body) || bounds.squaredExteriorDistance(rays.centre) > rays.radius * rays.radius) {
      return true;
    }
    for (std::size_t k = 0; k < rays.segments.size(); ++k) {
      const Segment& segment = rays.segments[k];
      const Eigen::AlignedBox3d around(segment.from.cwiseMin(segment.to), segment.from.cwiseMax(segment.to));
      if (!around.intersects(bounds)) {
        continue;
      }
      const double fraction = closestHit(segment, body->seen(), body->pose);
      RayHit& hit = hits[k];
      // of surfaces at the same distance, the older entity is hit, whatever the order of the query
      const Body* rival = fraction == hit.fraction && hit.row != kNoRow ? find(hit.row) : nullptr;
      if (fraction < hit.fraction || (rival != nullptr && body->number < rival->number)) {
        hit = {fraction, body->row};
      }
    }
    return true;
  });
}

bool Dynamics3d::blocks(Row row, const RayBundle& ray) const {
  SWARMANOID_EXPECTS(find(row) != nullptr);
  const Body& body = *find(row);
  return closestHit(ray.segments[0], body.seen(), body.pose) < 1.0;
}

}  // namespace swarmanoid::dynamics3d
