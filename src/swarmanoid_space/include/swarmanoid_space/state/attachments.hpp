/// Attachments of robots by holders other than a gripper: by ropes, suction, magnets. Unlike grips
/// (structural_tree.hpp), a robot may have several of them, also to fixed entities: a climbing robot hangs from the
/// ceiling and leans on a wall (thesis 1, 3.4).
///
/// A holder is an index of EntityModel::holders. Grippers have no attachments here.
///
/// Phase   written by engines in `connect`, and at tick boundaries; read in other phases.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "swarmanoid_space/state/entities.hpp"
#include "swarmanoid_space/state/structural_tree.hpp"

namespace swarmanoid {

struct Attachment {
  Row held = kNoRow;                                 ///< kNoRow: nothing is held
  Eigen::Vector3d anchor = Eigen::Vector3d::Zero();  ///< point at which it is held, in the body frame of `held` [m]
  double length = 0.0;                               ///< of a rope, from the robot to the anchor, when taut [m]
  double force = 0.0;                                ///< last force on it, without the noise of single steps [N]
};

void visitCell(StateVisitor& visitor, const char* name, const CellOwner& owner, Span<const Attachment> attachments);

class Attachments {
 public:
  explicit Attachments(Entities& entities);

  /// Removes all attachments.
  void clear();

  /// @pre the owner has that holder, the holder is free, and attachment.held is an entity
  void attach(Row owner, std::size_t holder, const Attachment& attachment);
  /// Does nothing if nothing is attached.
  void detach(Row owner, std::size_t holder);
  /// Removes all attachments of which an entity is the owner or the held entity, for example before it is deleted.
  void isolate(Row row);
  /// Updates the values that change during an attachment. @pre something is attached
  void update(Row owner, std::size_t holder, double length, double force);

  /// @pre the owner has that holder
  const Attachment& of(Row owner, std::size_t holder) const { return by_owner_[owner][holder]; }
  bool isEmpty() const { return count_ == 0; }
  bool isAttached(Row owner, std::size_t holder) const { return of(owner, holder).held != kNoRow; }
  /// Whether the entity holds any other.
  bool isAttached(Row owner) const;
  /// Whether any entity holds this one. Visits all entities if there are attachments.
  bool isHeld(Row held) const;

  /// For snapshots; the attachments themselves are a column.
  void archive(StateArchive& state) { state(count_); }

  /// Calls visit(holder, attachment) for each attachment of an entity, in the order of its holders.
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
  ListColumn<Attachment, WrittenIn::kConnect> by_owner_;
  std::size_t count_ = 0;
};

/// All movable entities connected to an entity by grips and attachments, itself included: the members of each structure
/// with parents before children.
std::vector<Row> connectedTo(const Entities& entities, const StructuralTree& structure, const Attachments& attachments,
                             Row row);

}  // namespace swarmanoid
