/// Shared by engines that simulate grips: the reach of a gripper, the event that reports a grip, and the grips of the
/// structural tree that an entity is part of.
#pragma once

#include <sstream>
#include <string>

#include "swarmanoid_interface/plain_text.hpp"
#include "swarmanoid_space/access.hpp"

namespace swarmanoid {

/// Distance from a gripper's tip to the gripping strip that it can close on [m].
constexpr double kGripperReach = 0.02;

/// The first commanded gripper of a robot, as an index into its holders; -1 if there is none.
inline int commandedGripper(const Space& space, Row row) {
  const EntityModel& model = *space.entities.model[row];
  for (std::size_t i = 0; model.gripper && i < model.holders.size(); ++i) {
    if (model.holders[i].kind == EntityModel::Holder::Kind::kGripper && space.holder_commands[row][i].is_commanded) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

/// Phase `connect`. @param kind kAttached or kReleased
inline void reportGrip(const Space& space, const ConnectAccess& access, Event::Kind kind, Row gripper, Row gripped,
                       const std::string& text = "") {
  const auto& names = space.entities.name;
  access.events.push_back({kind, names[gripper], names[gripped], text});
}

/// Text of the event for a grip that ended because it was pulled too hard. @param strength [N]
inline std::string tornText(double strength) {
  PlainTextStream text;
  text << "torn off: pulled with more than " << strength << " N";
  return text.str();
}

/// Calls visit(gripper, gripped) with the rows of every grip of an entity, as gripper or as gripped.
template <class Visit>
void visitGripsOf(Row row, const StructuralTree& structure, Visit visit) {
  if (const Row gripped = structure.grippedBy(row); gripped != kNoRow) {
    visit(row, gripped);
  }
  for (const Row gripper : structure.grippersOf(row)) {
    visit(gripper, row);
  }
}

}  // namespace swarmanoid
