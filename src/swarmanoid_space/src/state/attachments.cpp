#include "swarmanoid_space/state/attachments.hpp"

#include <algorithm>

#include "swarmanoid_interface/expects.hpp"

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

void Attachments::attach(Row owner, Attachment::Kind kind, const Attachment& attachment) {
  SWARMANOID_EXPECTS(!isAttached(owner, kind) && attachment.held != kNoRow);
  by_owner_[static_cast<std::size_t>(owner)][static_cast<std::size_t>(kind)] = attachment;
  ++count_;
}

void Attachments::detach(Row owner, Attachment::Kind kind) {
  if (isAttached(owner, kind)) {
    by_owner_[static_cast<std::size_t>(owner)][static_cast<std::size_t>(kind)] = Attachment{};
    --count_;
  }
}

void Attachments::update(Row owner, Attachment::Kind kind, double length, double force) {
  SWARMANOID_EXPECTS(isAttached(owner, kind));
  Attachment& attachment = by_owner_[static_cast<std::size_t>(owner)][static_cast<std::size_t>(kind)];
  attachment.length = length;
  attachment.force = force;
}

bool Attachments::isAttached(Row owner) const {
  const Slots& slots = at(owner);
  return std::any_of(slots.begin(), slots.end(), [](const Attachment& slot) { return slot.held != kNoRow; });
}

bool Attachments::isHeld(Row held) const {
  return !isEmpty() && std::any_of(by_owner_.begin(), by_owner_.end(), [held](const Slots& slots) {
    return std::any_of(slots.begin(), slots.end(), [held](const Attachment& slot) { return slot.held == held; });
  });
}

void Attachments::isolate(Row row) {
  if (isEmpty()) {
    return;
  }
  for (std::size_t owner = 0; owner < by_owner_.size(); ++owner) {
    for (std::size_t kind = 0; kind < Attachment::kKinds; ++kind) {
      if (static_cast<Row>(owner) == row || by_owner_[owner][kind].held == row) {
        detach(static_cast<Row>(owner), static_cast<Attachment::Kind>(kind));
      }
    }
  }
}

std::vector<Row> connectedTo(const Entities& entities, const StructuralTree& structure, const Attachments& attachments,
                             Row row) {
  std::vector<Row> result = structure.members(row);
  if (attachments.isEmpty()) {
    return result;
  }
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
