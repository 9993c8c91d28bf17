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

/// Phase `connect`. @param kind kAttached or kReleased
inline void reportGrip(Space& space, Event::Kind kind, Row gripper, Row gripped, const std::string& text = "") {
  const auto& names = space.entities.name;
  space.events.push_back(
      {kind, names[static_cast<std::size_t>(gripper)], names[static_cast<std::size_t>(gripped)], text});
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
