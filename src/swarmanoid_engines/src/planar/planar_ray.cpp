#include "planar/planar_ray.hpp"

#include <algorithm>
#include <cmath>

namespace swarmanoid::planar {
namespace {

/// The part of the ray that is inside, as fractions; empty once enter > leave.
struct Inside {
  double enter = 0.0;
  double leave = 1.0;

  void clip(double from, double to) {
    enter = std::max(enter, from);
    leave = std::min(leave, to);
  }
  void empty() { enter = kNoHit; }
  bool isEmpty() const { return enter > leave; }
};

void clipToBand(Inside& inside, const PlanarRay& ray, const Band& band, double offset) {
  const double low = band.low + offset;
  const double high = band.high + offset;
  if (ray.climb == 0.0) {
    if (ray.height < low || ray.height > high) {
      inside.empty();
    }
    return;
  }
  const double a = (low - ray.height) / ray.climb;
  const double b = (high - ray.height) / ray.climb;
  inside.clip(std::min(a, b), std::max(a, b));
}

void clipToCircle(Inside& inside, const PlanarRay& ray, const PlanarShape& circle) {
  const Eigen::Vector2d start = ray.from - circle.centre;
  const double a = ray.step.squaredNorm();
  const double b = start.dot(ray.step);
  const double c = start.squaredNorm() - circle.radius * circle.radius;
  if (a == 0.0) {
    if (c > 0.0) {
      inside.empty();
    }
    return;
  }
  const double discriminant = b * b - a * c;
  if (discriminant < 0.0) {
    inside.empty();
    return;
  }
  const double root = std::sqrt(discriminant);
  inside.clip((-b - root) / a, (-b + root) / a);
}

void clipToPolygon(Inside& inside, const PlanarRay& ray, const PlanarShape& polygon) {
  const Eigen::Vector2d* corner = &polygon.vertices.back();
  for (const Eigen::Vector2d& next : polygon.vertices) {
    const Eigen::Vector2d edge = next - *corner;
    const Eigen::Vector2d outward(edge.y(), -edge.x());
    const double distance = outward.dot(ray.from - *corner);
    const double approach = outward.dot(ray.step);
    corner = &next;
    if (distance > 0.0 && distance + approach > 0.0) {
      // all of the ray is on the edge's outer side: so it is most of the time
      inside.empty();
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
  // the ray's line misses the circle around the shape: so it is most of the time
  const Eigen::Vector2d start = ray.from - shape.centre;
  const double across = start.x() * ray.step.y() - start.y() * ray.step.x();
  if (across * across > shape.radius * shape.radius * ray.step.squaredNorm() && !ray.step.isZero(0.0)) {
    return kNoHit;
  }
  Inside inside;
  clipToBand(inside, ray, shape.band, offset);
  if (inside.isEmpty()) {
    return kNoHit;
  }
  if (shape.isCircle()) {
    clipToCircle(inside, ray, shape);
  } else {
    clipToPolygon(inside, ray, shape);
  }
  return inside.isEmpty() ? kNoHit : inside.enter;
}

}  // namespace swarmanoid::planar
