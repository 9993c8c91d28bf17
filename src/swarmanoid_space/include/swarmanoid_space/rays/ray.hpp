/// Rays: how sensors and lasers feel for surfaces, across all engines.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "swarmanoid_interface/range.hpp"
#include "swarmanoid_interface/span.hpp"
#include "swarmanoid_space/state/entities.hpp"

namespace swarmanoid {

/// A straight line from one point to another, in W [m].
struct Segment {
  Eigen::Vector3d from = Eigen::Vector3d::Zero();
  Eigen::Vector3d to = Eigen::Vector3d::Zero();
};

/// Where a segment first hits a surface. A segment that starts inside a solid hits it at fraction 0.
struct RayHit {
  double fraction = 1.0;  ///< of the way from `from` to `to`
  Row row = kNoRow;       ///< what was hit; kNoRow: nothing, or the terrain, which is no entity

  /// Whether anything was hit, be it an entity or the terrain.
  bool isHit() const { return fraction < 1.0; }
};

/// Some of up to 64 rays: a bit a ray, that of ray 0 the lowest.
using RayMask = std::uint64_t;

/// Calls visit(ray) for each ray of a mask, in their order.
template <class Visit>
void visitRays(RayMask mask, Visit visit) {
  for (; mask != 0; mask &= mask - 1) {
    visit(static_cast<std::size_t>(__builtin_ctzll(mask)));
  }
}

/// Segments cast together, such as a ring of sensors: one look-up of what is near serves all.
struct RayBundle {
  Span<const Segment> segments;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< of a sphere that holds all segments
  double radius = 0.0;                               ///< of that sphere [m]
  double lowest = -kInfinity;                        ///< no segment goes below that height [m]
  double highest = kInfinity;                        ///< or above this one; mostly left as they are
  Row ignored = kNoRow;                              ///< an entity that the rays pass through (the one that casts them)
  Row also_ignored = kNoRow;                         ///< a second one (the one looked at)
};

}  // namespace swarmanoid
