/// The agents of one world: a controller that commands its robots by the actions of the current step, and reads their
/// observations.
///
/// Threads  as the simulation that it is supplied to.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "agent_fields.hpp"
#include "swarmanoid_space/group_controller.hpp"

namespace swarmanoid {

class Agents final : public GroupController {
 public:
  /// @param observed, commanded outlive this object
  Agents(const AgentFields& observed, const AgentFields& commanded) : observed_(observed), commanded_(commanded) {}

  void init(const Configuration& /*parameters*/) override { slots_.clear(); }
  /// Gives the robot the first slot that is free. @throws ConfigError if it lacks a device
  void start(const Space& space, Banks& commands, Row row, Robot& robot) override;
  void step(const Space& space, Banks& commands, Span<const GroupMember> members) override;

  void archive(const Space& space, Banks& commands, StateArchive& state) override;

  std::size_t slotCount() const { return slots_.size(); }
  /// @param most number of slots from now on; robots beyond them are no agents
  void limitSlots(std::size_t most) { most_ = most; }
  /// @param actions [slots][action size] of the next steps; null: none yet, robots keep the commands that they have
  void setActions(const float* actions) { actions_ = actions, precise_actions_ = nullptr; }
  void setActions(const double* actions) { precise_actions_ = actions, actions_ = nullptr; }
  void setActions(std::nullptr_t) { actions_ = nullptr, precise_actions_ = nullptr; }
  /// Marks all agents as stepped, as before the first step of a run.
  void markAll();
  /// Reads the agents that were stepped in the last tick and remain. @param observations [most slots][observation
  /// size], present [most slots]; rows of others become 0
  void observe(const Space& space, float* observations, std::uint8_t* present) const;
  /// Calls visit(slot, row) for the agents that remain.
  template <class Visit>
  void visit(const Space& space, Visit visit) const {
    for (std::size_t i = 0; i < slots_.size() && i < most_; ++i) {
      if (remains(space, slots_[i])) {
        visit(i, slots_[i].row);
      }
    }
  }

 private:
  struct Slot {
    EntityNumber number = kNoEntity;
    Row row = kNoRow;
    const Robot* robot = nullptr;
    bool is_stepped = false;                // in the last tick
    std::vector<const std::byte*> sensors;  // of observations, field by field
    std::vector<std::byte*> actuators;      // of actions
  };

  static bool remains(const Space& space, const Slot& slot) {
    return slot.number != kNoEntity && toIndex(slot.row) < space.entities.rowCount() &&
           space.entities.number[slot.row] == slot.number;
  }
  /// Gives a slot the robot of a row. @throws ConfigError if it lacks a device
  void give(const Space& space, Banks& commands, Row row, Slot& slot) const;
  /// Returns the slot of a robot, or the end. @param from where the search begins
  std::vector<Slot>::iterator slotOf(const Robot* robot, std::vector<Slot>::iterator from);

  const AgentFields& observed_;
  const AgentFields& commanded_;
  const float* actions_ = nullptr;
  const double* precise_actions_ = nullptr;  // instead of actions_
  std::size_t most_ = SIZE_MAX;
  std::vector<Slot> slots_;
};

}  // namespace swarmanoid
