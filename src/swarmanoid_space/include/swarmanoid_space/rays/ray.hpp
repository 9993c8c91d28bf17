/// Rays: sensors and lasers find surfaces with them, across all engines.
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
  Row row = kNoRow;       ///< entity that was hit; kNoRow: none, or the terrain, which is not an entity

  /// Whether an entity or the terrain was hit.
  bool isHit() const { return fraction < 1.0; }
};

/// A set of up to 64 rays, one bit per ray; ray 0 is the lowest bit.
using RayMask = std::uint64_t;

/// Calls visit(ray) for each ray of a mask, in order.
template <class Visit>
void visitRays(RayMask mask, Visit visit) {
  for (; mask != 0; mask &= mask - 1) {
    visit(static_cast<std::size_t>(__builtin_ctzll(mask)));
  }
}

/// Segments cast together, such as a ring of sensors: they share one search for neighbours.
struct RayBundle {
  Span<const Segment> segments;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< of a sphere that contains all segments
  double radius = 0.0;                               ///< of that sphere [m]
  double lowest = -kInfinity;                        ///< no segment goes below this height [m]
  double highest = kInfinity;                        ///< or above this one; usually left at the defaults
  Row ignored = kNoRow;                              ///< an entity that the rays pass through (the caster)
  Row also_ignored = kNoRow;                         ///< a second one (the target)
};

}  // namespace swarmanoid
