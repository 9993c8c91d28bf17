/// Who is near a body, kept over some steps: so that not every look around goes through cells.
#pragma once

#include <array>
#include <cstdint>

#include "planar/bodies.hpp"

namespace swarmanoid::kinematics2d {

constexpr double kMostLookAhead = 0.3;  ///< m: far enough for many ticks, and yet few cells

/// The bodies that were near one when it last looked farther than it had to. Whoever is not listed is farther away than
/// what is left of that look by now. Distances are counted as in Clearance.
struct alignas(64) Neighbours {
  static constexpr std::size_t kMost = 11;

  double until = -1.0;          ///< up to this distance travelled nobody else can have come near
  float look = kMostLookAhead;  ///< how far to look the next time [m]
  std::uint16_t count = 0;
  std::uint16_t meeting = 0;  ///< those that it may meet in the step under way, a bit each
  std::array<planar::BodyIndex, kMost> bodies;

  std::uint32_t all() const { return (1U << count) - 1U; }

  /// With less to all others it is soon time to look again [m].
  double leastGap() const { return 0.25 * look; }
  /// How far away all others are at least, at a distance travelled [m].
  double gapToOthers(double travelled) const { return 2.0 * (until - travelled); }
};
static_assert(sizeof(Neighbours) == 64);

}  // namespace swarmanoid::kinematics2d
