#include "swarmanoid_space/attachments.hpp"

#include <algorithm>

namespace swarmanoid {

const char* toString(Attachment::Kind kind) {
  switch (kind) {
    case Attachment::Kind::kRope:
      return "rope";
    case Attachment::Kind::kLeftHand:
      return "left hand";
    case Attachment::Kind::kRightHand:
      return "right hand";
    case Attachment::Kind::kMagnet:
      return "magnet";
  }
  return "";
}

void Attachments::resize(std::size_t row_count) {
  if (row_count > by_owner_.size()) {
    by_owner_.resize(row_count);
  }
}

bool Attachments::isAttached(Row owner) const {
  const Slots& slots = at(owner);
  return std::any_of(slots.begin(), slots.end(), [](const Attachment& slot) { return slot.held != kNoRow; });
}

bool Attachments::isHeld(Row held) const {
  return std::any_of(by_owner_.begin(), by_owner_.end(), [held](const Slots& slots) {
    return std::any_of(slots.begin(), slots.end(), [held](const Attachment& slot) { return slot.held == held; });
  });
}

void Attachments::isolate(Row row) {
  by_owner_[static_cast<std::size_t>(row)] = Slots{};
  for (Slots& slots : by_owner_) {
    for (Attachment& slot : slots) {
      if (slot.held == row) {
        slot = Attachment{};
      }
    }
  }
}

std::vector<Row> connectedTo(const Entities& entities, const StructuralTree& structure, const Attachments& attachments,
                             Row row) {
  std::vector<Row> result = structure.members(row);
  const auto add = [&](Row other) {
    const bool is_movable = entities.model[static_cast<std::size_t>(other)]->is_movable;
    if (is_movable && std::find(result.begin(), result.end(), other) == result.end()) {
      const std::vector<Row> structure_of_other = structure.members(other);
      result.insert(result.end(), structure_of_other.begin(), structure_of_other.end());
    }
  };
  for (std::size_t k = 0; k < result.size(); ++k) {
    const Row member = result[k];
    attachments.visit(member, [&](Attachment::Kind, const Attachment& attachment) { add(attachment.held); });
    for (const Row owner : entities.order) {
      attachments.visit(owner, [&](Attachment::Kind, const Attachment& attachment) {
        if (attachment.held == member) {
          add(owner);
        }
      });
    }
  }
  return result;
}

}  // namespace swarmanoid
