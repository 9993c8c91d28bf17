#include "swarmanoid_space/state/structural_tree.hpp"

#include <algorithm>

namespace swarmanoid {

bool StructuralTree::connect(Row gripper, Row gripped) {
  if (grippedBy(gripper) != kNoRow || root(gripped) == gripper) {
    return false;
  }
  parent_[gripper] = gripped;
  children_[gripped].push_back(gripper);
  return true;
}

Row StructuralTree::release(Row gripper) {
  Row& parent = parent_[gripper];
  const Row gripped = parent;
  if (gripped != kNoRow) {
    std::vector<Row>& siblings = children_[gripped];
    siblings.erase(std::find(siblings.begin(), siblings.end(), gripper));
    parent = kNoRow;
  }
  return gripped;
}

void StructuralTree::isolate(Row row) {
  release(row);
  while (!grippersOf(row).empty()) {
    release(grippersOf(row).back());
  }
}

Row StructuralTree::root(Row row) const {
  while (grippedBy(row) != kNoRow) {
    row = grippedBy(row);
  }
  return row;
}

std::vector<Row> StructuralTree::members(Row row) const {
  std::vector<Row> result{root(row)};
  for (std::size_t i = 0; i < result.size(); ++i) {
    for (const Row gripper : grippersOf(result[i])) {
      result.push_back(gripper);
    }
  }
  return result;
}

}  // namespace swarmanoid
