#include "agents.hpp"

#include <algorithm>

namespace swarmanoid {

void Agents::start(const Space& space, Banks& commands, Row row, Robot& robot) {
  auto slot = std::find_if(slots_.begin(), slots_.end(),
                           [&](const Slot& each) { return each.robot == &robot || !remains(space, each); });
  if (slot == slots_.end()) {
    if (slots_.size() >= most_) {
      return;
    }
    slot = slots_.emplace(slots_.end());
  }
  slot->number = space.entities.number[row];
  slot->row = row;
  slot->robot = &robot;
  observed_.find(space.readings, row, slot->sensors);
  commanded_.find(commands, row, slot->actuators);
}

/// Members and slots are in the same order as a rule, so the guess is right.
Agents::Slot* Agents::slotOf(const GroupMember& member, std::size_t guess) {
  if (guess < slots_.size() && slots_[guess].robot == member.robot) {
    return &slots_[guess];
  }
  const auto found =
      std::find_if(slots_.begin(), slots_.end(), [&](const Slot& slot) { return slot.robot == member.robot; });
  return found == slots_.end() ? nullptr : &*found;
}

void Agents::step(const Space& /*space*/, Banks& /*commands*/, Span<const GroupMember> members) {
  for (Slot& slot : slots_) {
    slot.is_stepped = false;
  }
  for (std::size_t i = 0; i < members.size(); ++i) {
    Slot* slot = slotOf(members[i], i);
    if (slot == nullptr) {
      continue;
    }
    slot->is_stepped = true;
    if (actions_ != nullptr) {
      const auto place = static_cast<std::size_t>(slot - slots_.data());
      commanded_.scatter(actions_ + place * commanded_.size(), slot->actuators);
    }
  }
}

void Agents::markAll() {
  for (Slot& slot : slots_) {
    slot.is_stepped = true;
  }
}

std::size_t Agents::observe(const Space& space, float* observations, std::uint8_t* present) const {
  std::size_t count = 0;
  for (std::size_t i = 0; i < most_; ++i) {
    const bool is_present = i < slots_.size() && slots_[i].is_stepped && remains(space, slots_[i]);
    present[i] = is_present ? 1 : 0;
    count += present[i];
    if (is_present) {
      observed_.gather(slots_[i].sensors, observations);
    } else {
      std::fill_n(observations, observed_.size(), 0.0F);
    }
    observations += observed_.size();
  }
  return count;
}

}  // namespace swarmanoid
