#include "swarmanoid_space/state/attachments.hpp"

#include <algorithm>

#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid {

void visitCell(StateVisitor& visitor, const char* name, const CellOwner& owner, Span<const Attachment> attachments) {
  for (std::size_t holder = 0; holder < attachments.size(); ++holder) {
    const Attachment& attachment = attachments[holder];
    if (attachment.held == kNoRow) {
      continue;
    }
    const std::string_view member = owner.model.holders[holder].name;
    visitor.ordinal(holder);
    visitor.entity({name, member, "held"}, attachment.held);
    visitor.vector({name, member, "anchor"}, attachment.anchor);
    visitor.number({name, member, "length"}, attachment.length);
    if (visitor.wantsDetail()) {
      visitor.number({name, member, "force"}, attachment.force);
    }
  }
}

Attachments::Attachments(Entities& entities)
    : entities_(entities), by_owner_(entities.columns, {"attachment", Visits::kHash}, [](const EntityModel& model) {
        return model.holders.size();
      }) {}

void Attachments::clear() {
  for (const Row owner : entities_.order) {
    for (std::size_t holder = 0; holder < by_owner_[owner].size(); ++holder) {
      detach(owner, holder);
    }
  }
}

void Attachments::attach(Row owner, std::size_t holder, const Attachment& attachment) {
  SWARMANOID_EXPECTS(!isAttached(owner, holder) && attachment.held != kNoRow);
  by_owner_[owner][holder] = attachment;
  ++count_;
}

void Attachments::detach(Row owner, std::size_t holder) {
  if (isAttached(owner, holder)) {
    by_owner_[owner][holder] = Attachment{};
    --count_;
  }
}

void Attachments::update(Row owner, std::size_t holder, double length, double force) {
  SWARMANOID_EXPECTS(isAttached(owner, holder));
  Attachment& attachment = by_owner_[owner][holder];
  attachment.length = length;
  attachment.force = force;
}

bool Attachments::isAttached(Row owner) const {
  const Span<const Attachment> slots = by_owner_[owner];
  return std::any_of(slots.begin(), slots.end(), [](const Attachment& slot) { return slot.held != kNoRow; });
}

bool Attachments::isHeld(Row held) const {
  return !isEmpty() && std::any_of(entities_.order.begin(), entities_.order.end(), [&](Row owner) {
    const Span<const Attachment> slots = by_owner_[owner];
    return std::any_of(slots.begin(), slots.end(), [held](const Attachment& slot) { return slot.held == held; });
  });
}

void Attachments::isolate(Row row) {
  if (isEmpty()) {
    return;
  }
  for (const Row owner : entities_.order) {
    for (std::size_t holder = 0; holder < by_owner_[owner].size(); ++holder) {
      if (owner == row || by_owner_[owner][holder].held == row) {
        detach(owner, holder);
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
    const bool is_movable = entities.model[other]->is_movable;
    if (is_movable && std::find(result.begin(), result.end(), other) == result.end()) {
      const std::vector<Row> structure_of_other = structure.members(other);
      result.insert(result.end(), structure_of_other.begin(), structure_of_other.end());
    }
  };
  for (std::size_t k = 0; k < result.size(); ++k) {
    const Row member = result[k];
    attachments.visit(member, [&](std::size_t, const Attachment& attachment) { add(attachment.held); });
    for (const Row owner : entities.order) {
      attachments.visit(owner, [&](std::size_t, const Attachment& attachment) {
        if (attachment.held == member) {
          add(owner);
        }
      });
    }
  }
  return result;
}

}  // namespace swarmanoid
