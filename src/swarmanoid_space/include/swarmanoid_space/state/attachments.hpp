/// What robots hold on to by other means than a gripper: handbots by their rope and by the suction of their hands,
/// eyebots by their magnet. Unlike grips (structural_tree.hpp) these may be several for one robot, also on what is
/// fixed: a climbing handbot hangs on the ceiling and leans on a wall (thesis 1, 3.4).
///
/// Phase   written by engines in `connect`, and at tick boundaries; read by anyone else.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "swarmanoid_space/state/entities.hpp"
#include "swarmanoid_space/state/structural_tree.hpp"

namespace swarmanoid {

struct Attachment {
  enum class Kind {
    kRope,       ///< a handbot's, by its magnet at the end
    kLeftHand,   ///< a handbot's, by suction
    kRightHand,  ///< likewise
    kMagnet      ///< an eyebot's, at the ceiling
  };
  static constexpr std::size_t kKinds = 4;

  Row held = kNoRow;                                 ///< kNoRow: nothing
  Eigen::Vector3d anchor = Eigen::Vector3d::Zero();  ///< where it is held, in the body frame of `held` [m]
  double length = 0.0;                               ///< of a rope, from the robot to the anchor when taut [m]
  double force = 0.0;                                ///< on it at last, without the noise of single steps [N]
};

/// "rope", "left hand", "right hand", "magnet".
const char* toString(Attachment::Kind kind);

class Attachments {
 public:
  /// Rows up to `row_count` exist from now on, attached to nothing.
  void resize(std::size_t row_count);
  void clear() { *this = Attachments(); }

  /// @pre nothing is attached by that kind, and something is held
  void attach(Row owner, Attachment::Kind kind, const Attachment& attachment);
  /// Does nothing if nothing is attached.
  void detach(Row owner, Attachment::Kind kind);
  /// Undoes all attachments that an entity has or is held by, such as before it is deleted.
  void isolate(Row row);
  /// What changes while it holds. @pre something is attached
  void update(Row owner, Attachment::Kind kind, double length, double force);

  const Attachment& of(Row owner, Attachment::Kind kind) const { return at(owner)[static_cast<std::size_t>(kind)]; }
  bool isEmpty() const { return count_ == 0; }
  bool isAttached(Row owner, Attachment::Kind kind) const { return of(owner, kind).held != kNoRow; }
  /// Whether the entity holds on to anything.
  bool isAttached(Row owner) const;
  /// Whether anybody holds on to the entity. Goes through all entities if anything is attached.
  bool isHeld(Row held) const;

  /// Calls visit(kind, attachment) for what an entity holds on to, in the order of kinds.
  template <class Visit>
  void visit(Row owner, Visit visit) const {
    for (std::size_t kind = 0; kind < Attachment::kKinds; ++kind) {
      if (at(owner)[kind].held != kNoRow) {
        visit(static_cast<Attachment::Kind>(kind), at(owner)[kind]);
      }
    }
  }

 private:
  using Slots = std::array<Attachment, Attachment::kKinds>;
  const Slots& at(Row owner) const { return by_owner_[static_cast<std::size_t>(owner)]; }

  std::vector<Slots> by_owner_;
  std::size_t count_ = 0;
};

/// All that hangs together with an entity by grips and attachments and may move, itself included: the members of each
/// structure with parents before children.
std::vector<Row> connectedTo(const Entities& entities, const StructuralTree& structure, const Attachments& attachments,
                             Row row);

}  // namespace swarmanoid
