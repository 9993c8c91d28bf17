// Phase `connect`: robots grip preys and handbots, and release them.
#include "common/grips.hpp"
#include "kinematics2d/kinematics2d.hpp"
#include "planar/gripper_reach.hpp"

namespace swarmanoid::kinematics2d {

void Kinematics2d::connect(const Space& space, const ConnectAccess& access) {
  listBodies();
  for (const BodyIndex index : grippers_) {
    const Body& body = bodies_[index];
    if (body.gripper < 0) {
      continue;
    }
    if (!isGripperClosed(space, body)) {
      if (motion(index).gripped != kNoBody) {
        release(space, access, index);
      }
    } else if (mayGrip(index)) {
      const BodyIndex found = findGrippable(index);
      if (found != kNoBody) {
        grip(space, access, index, found);
      }
    }
  }
}

BodyIndex Kinematics2d::findGrippable(BodyIndex gripper) const {
  return planar::findInReach(bodies_, gripper, [&](BodyIndex index) {
    const Body& body = bodies_[index];
    return body.is_movable && body.role == Role::kMove && mayBeGripped(index);
  });
}

/// A body grips one object only. A gripped body moves with its gripper and grips nothing.
bool Kinematics2d::mayGrip(BodyIndex index) const {
  return motion(index).gripped == kNoBody && motion(index).gripped_by == kNoBody;
}

/// A prey has at most one gripper at a time, a robot without a drive any number. Robots with wheels, flying robots, and
/// bodies that grip something, cannot be gripped.
bool Kinematics2d::mayBeGripped(BodyIndex index) const {
  const Body& body = bodies_[index];
  if (motion(index).gripped != kNoBody) {
    return false;
  }
  return body.entity->is_robot ? !body.entity->wheels && !body.flies : motion(index).gripped_by == kNoBody;
}

void Kinematics2d::grip(const Space& space, const ConnectAccess& access, BodyIndex gripper_index,
                        BodyIndex gripped_index) {
  const Row gripper = bodies_[gripper_index].row;
  const Row gripped = bodies_[gripped_index].row;
  if (access.structure.connect(gripper, gripped)) {
    join(gripper_index, gripped_index);
    reportGrip(space, access, Event::Kind::kAttached, gripper, gripped);
  }
}

void Kinematics2d::join(BodyIndex gripper_index, BodyIndex gripped_index) {
  BodyIndex* next = &motion(gripped_index).gripped_by;
  while (*next != kNoBody && bodies_[*next].number < bodies_[gripper_index].number) {
    next = &motion(*next).next_gripper;
  }
  Motion& record = motion(gripper_index);
  record.next_gripper = *next;
  *next = gripper_index;
  record.gripped = gripped_index;
  clearance(gripper_index).free_until = -1.0;
  const PlacedPose& gripper = bodies_[gripper_index].pose;
  const PlacedPose& gripped = bodies_[gripped_index].pose;
  record.place_of_gripped = {gripper.unrotated(gripped.position - gripper.position), gripped.heading - gripper.heading};
  if (planar::Turret* turret = bodies_.findTurret(gripper_index)) {
    const PlacedPose turned = PlacedPose::at(gripper.position, gripper.heading + turret->sense * turret->state.angle);
    turret->held = {turned.unrotated(gripped.position - gripper.position), gripped.heading - turned.heading};
  }
}

namespace {

/// Reason why a grip cannot be held; "" if it can.
std::string unsupportedGripReason(const Space& space, Row gripped) {
  const EntityModel& model = *space.entities.model[gripped];
  const std::string name = "'" + space.entities.name[gripped] + "'";
  if (model.is_robot && (model.wheels || space.flight[gripped].is_driven)) {
    return "grips the robot " + name + ", which this engine cannot hold";
  }
  if (space.structure.grippedBy(gripped) != kNoRow) {
    return "grips " + name + " while that grips something, which this engine cannot hold";
  }
  const bool is_shared = !model.is_robot && space.structure.grippersOf(gripped).size() > 1;
  return is_shared ? "is not alone in gripping " + name + ", which this engine cannot hold" : "";
}

}  // namespace

std::string Kinematics2d::unsupportedStateReason(const Space& space, Row row) const {
  const Row gripped = space.structure.grippedBy(row);
  const std::string problem = gripped == kNoRow ? "" : unsupportedGripReason(space, gripped);
  return problem.empty() ? PlanarEngine::unsupportedStateReason(space, row) : problem;
}

void Kinematics2d::takeOverGrips(const Space& space, BodyIndex index) {
  visitGripsOf(bodies_[index].row, space.structure, [&](Row gripper_row, Row gripped_row) {
    const BodyIndex gripper = bodies_.find(gripper_row);
    const BodyIndex gripped = bodies_.find(gripped_row);
    const bool both_here = gripper != kNoBody && gripped != kNoBody && bodies_[gripper].role == Role::kMove &&
                           bodies_[gripped].role == Role::kMove;
    if (both_here && mayGrip(gripper) && mayBeGripped(gripped)) {
      join(gripper, gripped);
    }
  });
}

void Kinematics2d::release(const Space& space, const ConnectAccess& access, BodyIndex gripper_index) {
  const Row gripper = bodies_[gripper_index].row;
  reportGrip(space, access, Event::Kind::kReleased, gripper, bodies_[motion(gripper_index).gripped].row);
  access.structure.release(gripper);
  letGo(gripper_index);
}

void Kinematics2d::letGo(BodyIndex gripper) {
  Motion& record = motion(gripper);
  BodyIndex* next = &motion(record.gripped).gripped_by;
  while (*next != gripper) {
    next = &motion(*next).next_gripper;
  }
  *next = record.next_gripper;
  record.next_gripper = kNoBody;
  record.gripped = kNoBody;
}

void Kinematics2d::forgetGrips(BodyIndex index) {
  if (motion(index).gripped != kNoBody) {
    letGo(index);
  }
  while (motion(index).gripped_by != kNoBody) {
    letGo(motion(index).gripped_by);
  }
}

}  // namespace swarmanoid::kinematics2d
