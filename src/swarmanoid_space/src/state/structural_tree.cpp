#include "swarmanoid_space/state/structural_tree.hpp"

#include <algorithm>

namespace swarmanoid {

void StructuralTree::resize(std::size_t row_count) {
  if (row_count > parent_.size()) {
    parent_.resize(row_count, kNoRow);
    const std::size_t known = children_.size();
    children_.resize(row_count);
    constexpr std::size_t kUsualGrippers = 2;  // so that a grip allocates nothing
    std::for_each(children_.begin() + static_cast<std::ptrdiff_t>(known), children_.end(),
                  [](std::vector<Row>& grippers) { grippers.reserve(kUsualGrippers); });
  }
}

void StructuralTree::clear() {
  parent_.clear();
  children_.clear();
}

bool StructuralTree::connect(Row gripper, Row gripped) {
  if (grippedBy(gripper) != kNoRow || root(gripped) == gripper) {
    return false;
  }
  parent_[static_cast<std::size_t>(gripper)] = gripped;
  children_[static_cast<std::size_t>(gripped)].push_back(gripper);
  return true;
}

Row StructuralTree::release(Row gripper) {
  Row& parent = parent_[static_cast<std::size_t>(gripper)];
  const Row gripped = parent;
  if (gripped != kNoRow) {
    std::vector<Row>& siblings = children_[static_cast<std::size_t>(gripped)];
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
