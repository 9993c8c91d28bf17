#include "planar/planar_ray.hpp"

#include "swarmanoid_space/rays/line_part.hpp"

namespace swarmanoid::planar {
namespace {

void clipToPolygon(LinePart& inside, const PlanarRay& ray, const PlanarShape& polygon) {
  const Eigen::Vector2d* corner = &polygon.vertices.back();
  for (const Eigen::Vector2d& next : polygon.vertices) {
    const Eigen::Vector2d edge = next - *corner;
    const Eigen::Vector2d outward(edge.y(), -edge.x());
    const double distance = outward.dot(ray.from - *corner);
    const double approach = outward.dot(ray.step);
    corner = &next;
    if (distance > 0.0 && distance + approach > 0.0) {
      // the whole ray is on the edge's outer side, the most frequent case
      inside.clear();
      return;
    }
    if (approach < 0.0) {
      inside.clip(-distance / approach, kNoHit);
    } else if (approach > 0.0) {
      inside.clip(-kNoHit, -distance / approach);
    }
  }
}

}  // namespace

double closestHit(const PlanarRay& ray, const PlanarShape& shape, double offset) {
  // the most frequent cases: the ray passes over or under the shape, or its line misses the circle around it
  const double low = shape.band.low + offset;
  const double high = shape.band.high + offset;
  if ((ray.height > high && ray.height + ray.climb > high) || (ray.height < low && ray.height + ray.climb < low)) {
    return kNoHit;
  }
  const Eigen::Vector2d start = ray.from - shape.centre;
  const double across = start.x() * ray.step.y() - start.y() * ray.step.x();
  if (across * across > shape.radius * shape.radius * ray.step.squaredNorm() && !ray.step.isZero(0.0)) {
    return kNoHit;
  }
  LinePart inside;
  inside.clipToSlab(ray.height, ray.climb, low, high);
  if (inside.isEmpty()) {
    return kNoHit;
  }
  if (shape.isCircle()) {
    inside.clipToRound(start, ray.step, shape.radius);
  } else {
    clipToPolygon(inside, ray, shape);
  }
  return inside.isEmpty() ? kNoHit : inside.from;
}

}  // namespace swarmanoid::planar
