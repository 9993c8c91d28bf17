/// Who grips whom (thesis 3.4, "structural information").
///
/// The gripped entity is the parent of those that grip it; an entity grips at most one other, so every structure is a
/// tree whose root is what grips nothing. A grip that would close a loop is refused.
///
/// Phase   written by engines in `connect`; read by anyone else.
#pragma once

#include <string>
#include <vector>

#include "swarmanoid_space/state/entities.hpp"

namespace swarmanoid {

class StructuralTree {
 public:
  explicit StructuralTree(Columns& columns)
      : parent_(columns, {"gripped", Writer::kConnect, Visits::kHash}, kNoRow),
        children_(columns, {"grippers", Writer::kConnect}) {}

  /// @return false, and nothing changes, if `gripper` already grips something or the grip would close a loop
  bool connect(Row gripper, Row gripped);
  /// @return what was gripped; kNoRow if nothing was
  Row release(Row gripper);
  /// Lets go of everything that `row` grips or is gripped by, such as before it is deleted.
  void isolate(Row row);

  Row grippedBy(Row gripper) const { return parent_[gripper]; }
  const std::vector<Row>& grippersOf(Row gripped) const { return children_[gripped]; }
  /// The entity at the bottom of the structure that `row` belongs to; itself if it grips nothing.
  Row root(Row row) const;
  /// All members of `row`'s structure: the root first, then the others, parents before children.
  std::vector<Row> members(Row row) const;

 private:
  /// Has room for a few from the start, in copies too, so that a grip allocates nothing.
  struct Grippers : std::vector<Row> {
    Grippers() { reserve(2); }
    Grippers(const Grippers& other) : Grippers() { assign(other.begin(), other.end()); }
    Grippers(Grippers&&) noexcept = default;
    Grippers& operator=(const Grippers&) = default;
    Grippers& operator=(Grippers&&) noexcept = default;
    ~Grippers() = default;
  };

  Column<Row> parent_;
  Column<Grippers> children_;
};

}  // namespace swarmanoid
