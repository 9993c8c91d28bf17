/// The graph of grips between entities (thesis 3.4, "structural information").
///
/// The gripped entity is the parent of its grippers. An entity grips at most one other, so every structure is a tree;
/// its root grips nothing. A grip that would close a loop is refused.
///
/// Phase   written by engines in `connect`; read in other phases.
#pragma once

#include <string>
#include <vector>

#include "swarmanoid_space/state/entities.hpp"

namespace swarmanoid {

class StructuralTree {
 public:
  explicit StructuralTree(Columns& columns)
      : parent_(columns, {"gripped", Visits::kHash}, kNoRow), children_(columns, {"grippers"}) {}

  /// @return false, and nothing changes, if `gripper` already grips something or the grip would close a loop
  bool connect(Row gripper, Row gripped);
  /// @return the entity that was gripped; kNoRow if there was none
  Row release(Row gripper);
  /// Releases all grips of which `row` is the gripper or the gripped entity, for example before it is deleted.
  void isolate(Row row);

  Row grippedBy(Row gripper) const { return parent_[gripper]; }
  const std::vector<Row>& grippersOf(Row gripped) const { return children_[gripped]; }
  /// The root of the structure that `row` belongs to; itself if it grips nothing.
  Row root(Row row) const;
  /// All members of `row`'s structure: the root first, then the others, parents before children.
  std::vector<Row> members(Row row) const;

 private:
  /// Reserves memory for a few entries, in copies too, so that a grip does not allocate.
  struct Grippers : std::vector<Row> {
    Grippers() { reserve(2); }
    Grippers(const Grippers& other) : Grippers() { assign(other.begin(), other.end()); }
    Grippers(Grippers&&) noexcept = default;
    Grippers& operator=(const Grippers&) = default;
    Grippers& operator=(Grippers&&) noexcept = default;
    ~Grippers() = default;

    void archive(StateArchive& state) { state(static_cast<std::vector<Row>&>(*this)); }
  };

  Column<Row, WrittenIn::kConnect> parent_;
  Column<Grippers, WrittenIn::kConnect> children_;
};

}  // namespace swarmanoid
