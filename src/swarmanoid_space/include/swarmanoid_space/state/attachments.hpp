/// What robots hold on to by other holders than a gripper: by ropes, by suction, by magnets. Unlike grips
/// (structural_tree.hpp) these may be several for one robot, also on what is fixed: a climbing robot hangs on the
/// ceiling and leans on a wall (thesis 1, 3.4).
///
/// A holder is an index of EntityModel::holders. Those of grippers hold nothing here.
///
/// Phase   written by engines in `connect`, and at tick boundaries; read by anyone else.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "swarmanoid_space/state/entities.hpp"
#include "swarmanoid_space/state/structural_tree.hpp"

namespace swarmanoid {

struct Attachment {
  Row held = kNoRow;                                 ///< kNoRow: nothing
  Eigen::Vector3d anchor = Eigen::Vector3d::Zero();  ///< where it is held, in the body frame of `held` [m]
  double length = 0.0;                               ///< of a rope, from the robot to the anchor when taut [m]
  double force = 0.0;                                ///< on it at last, without the noise of single steps [N]
};

void visitCell(StateVisitor& visitor, const char* name, const CellOwner& owner, Span<const Attachment> attachments);

class Attachments {
 public:
  explicit Attachments(Entities& entities);

  /// Undoes all.
  void clear();

  /// @pre the owner has that holder, it holds nothing, and something is held
  void attach(Row owner, std::size_t holder, const Attachment& attachment);
  /// Does nothing if nothing is attached.
  void detach(Row owner, std::size_t holder);
  /// Undoes all attachments that an entity has or is held by, such as before it is deleted.
  void isolate(Row row);
  /// What changes while it holds. @pre something is attached
  void update(Row owner, std::size_t holder, double length, double force);

  /// @pre the owner has that holder
  const Attachment& of(Row owner, std::size_t holder) const { return by_owner_[owner][holder]; }
  bool isEmpty() const { return count_ == 0; }
  bool isAttached(Row owner, std::size_t holder) const { return of(owner, holder).held != kNoRow; }
  /// Whether the entity holds on to anything.
  bool isAttached(Row owner) const;
  /// Whether anybody holds on to the entity. Goes through all entities if anything is attached.
  bool isHeld(Row held) const;

  /// Calls visit(holder, attachment) for what an entity holds on to, in the order of its holders.
  template <class Visit>
  void visit(Row owner, Visit visit) const {
    const Span<const Attachment> slots = by_owner_[owner];
    for (std::size_t holder = 0; holder < slots.size(); ++holder) {
      if (slots[holder].held != kNoRow) {
        visit(holder, slots[holder]);
      }
    }
  }

 private:
  const Entities& entities_;
  ListColumn<Attachment> by_owner_;
  std::size_t count_ = 0;
};

/// All that hangs together with an entity by grips and attachments and may move, itself included: the members of each
/// structure with parents before children.
std::vector<Row> connectedTo(const Entities& entities, const StructuralTree& structure, const Attachments& attachments,
                             Row row);

}  // namespace swarmanoid
