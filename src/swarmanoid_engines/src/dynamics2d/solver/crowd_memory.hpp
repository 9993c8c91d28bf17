/// Contact forces of large islands, which warm-start the solver in the next tick.
///
/// Forces spread through a crowd by one row of robots a sweep. Without the forces of the last tick, each tick would
/// begin with an unsupported crowd. They are only a first guess, so the forces of bodies that were placed elsewhere do
/// no harm.
///
/// Threads: one at a time for each object.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "dynamics2d/solver/constraints.hpp"
#include "swarmanoid_interface/state_archive.hpp"
#include "swarmanoid_space/state/entities.hpp"

namespace swarmanoid::dynamics2d {

/// Two bodies by their entities.
struct BodyNumbers {
  EntityNumber a = kNoEntity;
  EntityNumber b = kNoEntity;
};

class CrowdMemory {
 public:
  /// Forgets all forces.
  void clear();
  /// Stores the forces of a contact until the next tick. @param step length of the step of its impulses [s]
  void keep(const BodyNumbers& bodies, const ContactConstraint& contact, double step);
  /// Ends a tick: the forces that it stored replace those of the tick before.
  void finishTick();
  /// Appends the contacts of two bodies in the last tick, with their impulses in a step. @param pair index of the pair
  /// of bodies in the island @param step [s]
  void recall(const BodyNumbers& bodies, int pair, double step, std::vector<ContactConstraint>& contacts) const;
  /// Between ticks, for snapshots.
  void archive(StateArchive& state) { state(last_); }

 private:
  struct Kept {
    BodyNumbers bodies;
    std::uint32_t shapes = 0;
    ContactPatch patch;
    std::array<double, 2> loads{};      // along the normal [N]
    std::array<double, 2> frictions{};  // across it, to the left [N]
  };

  std::vector<Kept> last_;  // by bodies
  std::vector<Kept> next_;
};

}  // namespace swarmanoid::dynamics2d
