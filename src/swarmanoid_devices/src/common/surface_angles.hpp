/// Angles of incidence of rays on the surfaces that they hit, for sensors whose readings depend on them.
///
/// For each ray with a hit two more rays are cast, 10 um aside; the three hit points span the surface. If one of the
/// two hits nothing, or another entity, the surface counts as perpendicular in its direction. Angles up to 89 degrees
/// are accurate if the surface is flat over these 10 um. A ray that begins inside a solid has angle 0.
///
/// Threads: const functions, safe from any number of threads; they allocate nothing.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

constexpr double kAsideOfRay = 1e-5;   // m
constexpr double kBackFromRay = 1e-3;  // by which a ray aside begins earlier, to hit surfaces leaning to the sensor, m

/// A parallel ray, extended at both ends.
inline Segment rayAside(const Segment& ray, const Eigen::Vector3d& direction, const Eigen::Vector3d& aside) {
  return {ray.from + kAsideOfRay * aside - kBackFromRay * direction,
          ray.to + kAsideOfRay * aside + kBackFromRay * direction};
}

/// Difference between the distance of the hit aside and that of the hit, per metre aside.
/// @param length of the ray [m]
inline double slopeBetween(const RayHit& hit, const RayHit& hit_aside, double length) {
  if (hit.fraction <= 0.0 || !hit_aside.isHit() || hit_aside.row != hit.row) {
    return 0.0;
  }
  const double way = hit_aside.fraction * (length + 2.0 * kBackFromRay) - kBackFromRay;
  return (way - hit.fraction * length) / kAsideOfRay;
}

/// Calls visit(index of the ray, distance of its hit [m], angle between the ray and the surface normal [rad]) for each
/// ray that hits something, in order.
/// @param cast function that cast the rays: void(const Space&, const RayBundle&, Span<RayHit>)
/// @param rays with segments of equal length @param hits their hits
template <std::size_t most, class Cast, class Visit>
void visitSurfaces(const Space& space, RayBundle rays, Span<const RayHit> hits, Cast cast, Visit visit) {
  const Span<const Segment> segments = rays.segments;
  std::array<Segment, 2 * most> beside;
  std::array<RayHit, 2 * most> hits_beside;
  std::size_t count = 0;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (hits[i].isHit()) {
      const Eigen::Vector3d direction = (segments[i].to - segments[i].from).normalized();
      const Eigen::Vector3d aside = direction.unitOrthogonal();
      beside[count++] = rayAside(segments[i], direction, aside);
      beside[count++] = rayAside(segments[i], direction, direction.cross(aside));
    }
  }
  if (count == 0) {
    return;
  }
  rays.segments = Span<const Segment>(beside.data(), count);
  rays.radius += kBackFromRay + kAsideOfRay;
  cast(space, rays, Span<RayHit>(hits_beside.data(), count));
  count = 0;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (hits[i].isHit()) {
      const double length = (segments[i].to - segments[i].from).norm();
      const double one = slopeBetween(hits[i], hits_beside[count++], length);
      const double other = slopeBetween(hits[i], hits_beside[count++], length);
      visit(i, hits[i].fraction * length, std::atan(std::sqrt(one * one + other * other)));
    }
  }
}

}  // namespace swarmanoid::devices
