/// What engines that hold grips have in common: how far a gripper reaches, which event reports a grip, and which grips
/// of the structural tree an entity is part of.
#pragma once

#include <sstream>
#include <string>

#include "swarmanoid_interface/plain_text.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

/// From a gripper's tip to the gripping strip that it can close on [m].
constexpr double kGripperReach = 0.02;

/// The first gripper of a robot that is commanded, as an index of its holders; -1: there is none.
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
inline void reportGrip(Space& space, Event::Kind kind, Row gripper, Row gripped, const std::string& text = "") {
  const auto& names = space.entities.name;
  space.events.push_back({kind, names[gripper], names[gripped], text});
}

/// The text of the event in which a grip ends that was pulled too hard. @param strength [N]
inline std::string tornText(double strength) {
  PlainTextStream text;
  text << "torn off: pulled with more than " << strength << " N";
  return text.str();
}

/// Calls visit(gripper, gripped) with the rows of every grip that an entity has, or is held by.
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
