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
  give(space, commands, row, *slot);
}

void Agents::give(const Space& space, Banks& commands, Row row, Slot& slot) const {
  slot.number = space.entities.number[row];
  slot.row = row;
  slot.robot = space.robots[row].get();
  observed_.find(space.readings, row, slot.sensors);
  commanded_.find(commands, row, slot.actuators);
}

void Agents::archive(const Space& space, Banks& commands, StateArchive& state) {
  std::size_t count = slots_.size();
  state(count);
  slots_.resize(count);
  for (Slot& slot : slots_) {
    const EntityNumber before = slot.number;
    state(slot.number, slot.row, slot.is_stepped);
    if (state.isLoading() && remains(space, slot)) {
      give(space, commands, slot.row, slot);
    } else if (slot.number != before) {
      slot.robot = nullptr;  // of a robot that is gone
    }
  }
}

/// Members and slots are in the same order as a rule, so the search from the slot of the last member is short.
std::vector<Agents::Slot>::iterator Agents::slotOf(const Robot* robot, std::vector<Slot>::iterator from) {
  const auto is_its = [robot](const Slot& slot) { return slot.robot == robot; };
  const auto found = std::find_if(from, slots_.end(), is_its);
  if (found != slots_.end()) {
    return found;
  }
  const auto before = std::find_if(slots_.begin(), from, is_its);
  return before == from ? slots_.end() : before;
}

void Agents::step(const Space& /*space*/, Banks& /*commands*/, Span<const GroupMember> members) {
  for (Slot& slot : slots_) {
    slot.is_stepped = false;
  }
  auto next = slots_.begin();
  for (const GroupMember& member : members) {
    const auto slot = slotOf(member.robot, next);
    if (slot == slots_.end()) {
      continue;
    }
    next = slot + 1;
    slot->is_stepped = true;
    const auto first = static_cast<std::size_t>(slot - slots_.begin()) * commanded_.size();
    if (actions_ != nullptr) {
      commanded_.scatter(actions_ + first, slot->actuators);
    } else if (precise_actions_ != nullptr) {
      commanded_.scatter(precise_actions_ + first, slot->actuators);
    }
  }
}

void Agents::markAll() {
  for (Slot& slot : slots_) {
    slot.is_stepped = true;
  }
}

void Agents::observe(const Space& space, float* observations, std::uint8_t* present) const {
  for (std::size_t i = 0; i < most_; ++i) {
    const bool is_present = i < slots_.size() && slots_[i].is_stepped && remains(space, slots_[i]);
    present[i] = is_present ? 1 : 0;
    if (is_present) {
      observed_.gather(slots_[i].sensors, observations);
    } else {
      std::fill_n(observations, observed_.size(), 0.0F);
    }
    observations += observed_.size();
  }
}

}  // namespace swarmanoid
