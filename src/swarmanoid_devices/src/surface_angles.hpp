/// At what angle rays meet the surfaces that they hit: for sensors whose readings depend on it.
///
/// Beside each ray that hits something two more are cast, 10 um aside; the three points span the surface. Where one of
/// the two hits nothing, or something else, the surface counts as straight in its direction. Angles up to 89 degrees
/// are right as far as the surface is flat over these 10 um. What a ray begins in, it meets straight on.
///
/// Threads: const from any number of them; nothing is allocated.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

constexpr double kAsideOfRay = 1e-5;   // m
constexpr double kBackFromRay = 1e-3;  // by which a ray aside begins earlier, to meet what leans towards the sensor, m

/// A ray beside another one, longer at both ends.
inline Segment rayAside(const Segment& ray, const Eigen::Vector3d& direction, const Eigen::Vector3d& aside) {
  return {ray.from + kAsideOfRay * aside - kBackFromRay * direction,
          ray.to + kAsideOfRay * aside + kBackFromRay * direction};
}

/// How much farther than the hit of a ray that of one aside is, for each metre aside.
/// @param length of the ray [m]
inline double slopeBetween(const RayHit& hit, const RayHit& hit_aside, double length) {
  if (hit.fraction <= 0.0 || !hit_aside.isHit() || hit_aside.row != hit.row) {
    return 0.0;
  }
  const double way = hit_aside.fraction * (length + 2.0 * kBackFromRay) - kBackFromRay;
  return (way - hit.fraction * length) / kAsideOfRay;
}

/// Calls visit(number of the ray, way to what it hits [m], angle between the ray and the surface's normal [rad]) for
/// each ray that hits something, in their order.
/// @param cast by which the rays were: void(const Space&, const RayBundle&, Span<RayHit>)
/// @param rays with their segments, which all are as long @param hits of these
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
