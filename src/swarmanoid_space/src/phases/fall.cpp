// Last part of phase 5: entities that have lost the ground fall into a hole.
//
// An entity can lose the ground if an engine moves it, it does not fly, and it stands on the level floor: its lowest
// point is at most kStep above it. It has lost the ground when its centre of mass is over a hole, or both of its wheels
// are. Connected entities support each other: all of them fall when more than half of their mass has lost the ground,
// and none if one of them is fixed. The check runs once per tick, so an entity that crosses a hole within a tick does
// not fall.
#include <algorithm>
#include <string>
#include <vector>

#include "phases.hpp"

namespace swarmanoid::phases {
namespace {

bool standsOnTheFloor(const EntityModel& model, const Pose& pose) {
  constexpr double kStep = 0.01;  // m
  const Eigen::Vector3d up = pose.orientation.conjugate() * Eigen::Vector3d::UnitZ();
  return std::any_of(model.shapes.begin(), model.shapes.end(), [&](const CollisionShape& shape) {
    return pose.toWorld(shape.position).z() - shape.reachAlong(up) <= kStep;
  });
}

/// Returns the hole below the centre of mass, or the one below the left wheel if the right wheel is over a hole too.
const FloorHole* holeBelow(const Space& space, const EntityModel& model, const Pose& pose) {
  const FloorHole* hole = space.holeAt(pose.toWorld(model.centre_of_mass));
  if (hole != nullptr || !model.wheels) {
    return hole;
  }
  const Eigen::Vector3d left(0.0, 0.5 * model.wheels->separation, 0.0);
  return space.holeAt(pose.toWorld(-left)) != nullptr ? space.holeAt(pose.toWorld(left)) : nullptr;
}

/// Returns the hole into which the entity would fall without support by others; null if it has ground below, or needs
/// none.
const FloorHole* lostGround(const Space& space, Row row) {
  const EntityModel& model = *space.entities.model[row];
  if (!model.is_movable || space.mover[row] == nullptr || space.flight[row].is_driven) {
    return nullptr;
  }
  const Pose& pose = space.entities.pose[row];
  const FloorHole* hole = holeBelow(space, model, pose);
  return hole != nullptr && standsOnTheFloor(model, pose) ? hole : nullptr;
}

bool isAmong(const std::vector<Row>& rows, Row row) { return std::find(rows.begin(), rows.end(), row) != rows.end(); }

void addMember(Row row, std::vector<Row>& members) {
  if (row != kNoRow && !isAmong(members, row)) {
    members.push_back(row);
  }
}

/// Collects the entities connected to one, including the fixed ones that they hold on to. As connectedTo, without
/// allocating.
void collectConnected(const Space& space, Row row, std::vector<Row>& members) {
  members.assign(1, row);
  for (std::size_t k = 0; k < members.size(); ++k) {
    const Row member = members[k];
    if (!space.entities.model[member]->is_movable) {
      continue;
    }
    addMember(space.structure.grippedBy(member), members);
    for (const Row gripper : space.structure.grippersOf(member)) {
      addMember(gripper, members);
    }
    if (space.attachments.isEmpty()) {
      continue;
    }
    space.attachments.visit(member,
                            [&](std::size_t, const Attachment& attachment) { addMember(attachment.held, members); });
    for (const Row other : space.entities.order) {
      space.attachments.visit(other, [&](std::size_t, const Attachment& attachment) {
        if (attachment.held == member) {
          addMember(other, members);
        }
      });
    }
  }
}

/// Returns whether the members with ground below cannot hold the others.
bool isTooHeavy(const Space& space, const std::vector<Row>& members) {
  double lost = 0.0;
  double mass = 0.0;
  bool are_all_lost = true;
  for (const Row member : members) {
    const EntityModel& model = *space.entities.model[member];
    if (!model.is_movable) {
      return false;
    }
    const bool is_lost = lostGround(space, member) != nullptr;
    mass += model.mass;
    lost += is_lost ? model.mass : 0.0;
    are_all_lost = are_all_lost && is_lost;
  }
  return are_all_lost || 2.0 * lost > mass;
}

/// @param drawer falling entity that pulls in members with ground below @param hole into which the drawer falls
Event fallOf(const Space& space, Row row, Row drawer, const FloorHole& hole) {
  const FloorHole* own = lostGround(space, row);
  const std::string what = own != nullptr ? "hole '" + own->id + "'"
                                          : "hole '" + hole.id + "', drawn by '" + space.entities.name[drawer] + "'";
  return {Event::Kind::kFellIntoHole, space.entities.name[row], "", what};
}

}  // namespace

void fall(const Space& space, std::vector<Row>& fallen, std::vector<Event>& events) {
  fallen.clear();
  if (space.floor.holes.empty()) {
    return;
  }
  thread_local std::vector<Row> members;
  for (const Row row : space.entities.order) {
    const FloorHole* hole = lostGround(space, row);
    if (hole == nullptr || isAmong(fallen, row)) {
      continue;
    }
    collectConnected(space, row, members);
    if (!isTooHeavy(space, members)) {
      continue;
    }
    std::sort(members.begin(), members.end(),
              [&](Row a, Row b) { return space.entities.number[a] < space.entities.number[b]; });
    for (const Row member : members) {
      fallen.push_back(member);
      events.push_back(fallOf(space, member, row, *hole));
    }
  }
}

}  // namespace swarmanoid::phases
