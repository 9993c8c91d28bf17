/// Neighbours of a body, cached over some steps, so that not every search goes through the cells.
#pragma once

#include <array>
#include <cstdint>

#include "planar/bodies.hpp"

namespace swarmanoid::kinematics2d {

constexpr double kMostLookAhead = 0.3;  ///< range of a search, at most [m]: lasts for many ticks, in few cells

/// Bodies near a body in its last search of the cells, which went farther than needed. All bodies that are not listed
/// are farther away than the part of that range that is still left. Distances are counted as in Clearance.
struct alignas(64) Neighbours {
  static constexpr std::size_t kMost = 11;

  double until = -1.0;          ///< up to this distance travelled no other body can have come near
  float look = kMostLookAhead;  ///< range of the next search [m]
  std::uint16_t count = 0;
  std::uint16_t meeting = 0;  ///< bodies that it may meet in the current step, one bit each
  std::array<planar::BodyIndex, kMost> bodies;

  std::uint32_t all() const { return (1U << count) - 1U; }

  /// Gap to unlisted bodies at which the list is due for renewal [m].
  double leastGap() const { return 0.25 * look; }
  /// Lower bound of the gap to unlisted bodies, at a distance travelled [m].
  double gapToOthers(double travelled) const { return 2.0 * (until - travelled); }
};
static_assert(sizeof(Neighbours) == 64);

}  // namespace swarmanoid::kinematics2d
