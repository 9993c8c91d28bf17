// Phase `connect`: robots grip preys and let go of them.
#include "common/grips.hpp"
#include "kinematics2d/kinematics2d.hpp"
#include "planar/gripper_reach.hpp"

namespace swarmanoid::kinematics2d {

void Kinematics2d::connect(Space& space) {
  for (const BodyIndex index : bodies_.order()) {
    const Body& body = bodies_[index];
    if (body.gripper < 0 || body.role == Role::kMirror) {
      continue;
    }
    if (!isGripperClosed(space, body)) {
      if (motion(index).gripped != kNoBody) {
        release(space, index);
      }
    } else if (motion(index).gripped == kNoBody) {
      const BodyIndex prey = findPrey(index);
      if (prey != kNoBody) {
        grip(space, index, prey);
      }
    }
  }
}

BodyIndex Kinematics2d::findPrey(BodyIndex gripper) const {
  return planar::findInReach(bodies_, gripper, [&](BodyIndex index) {
    const Body& prey = bodies_[index];
    return !prey.entity->is_robot && prey.is_movable && prey.role == Role::kMove && motion(index).gripped_by == kNoBody;
  });
}

void Kinematics2d::grip(Space& space, BodyIndex gripper_index, BodyIndex prey_index) {
  const Row gripper = bodies_[gripper_index].row;
  const Row prey = bodies_[prey_index].row;
  if (space.structure.connect(gripper, prey)) {
    join(gripper_index, prey_index);
    reportGrip(space, Event::Kind::kAttached, gripper, prey);
  }
}

void Kinematics2d::join(BodyIndex gripper_index, BodyIndex prey_index) {
  motion(gripper_index).gripped = prey_index;
  motion(prey_index).gripped_by = gripper_index;
  const PlacedPose& gripper = bodies_[gripper_index].pose;
  const PlacedPose& prey = bodies_[prey_index].pose;
  motion(prey_index).place_in_gripper = {gripper.unrotated(prey.position - gripper.position),
                                         prey.heading - gripper.heading};
  if (planar::Turret* turret = bodies_.findTurret(gripper_index)) {
    const PlacedPose turned = PlacedPose::at(gripper.position, gripper.heading + turret->sense * turret->state.angle);
    turret->held = {turned.unrotated(prey.position - gripper.position), prey.heading - turned.heading};
  }
}

std::string Kinematics2d::unsupportedGripReason(const Space& space, Row gripper) const {
  const Row gripped = space.structure.grippedBy(gripper);
  if (space.entities.model[gripped]->is_robot) {
    return "grips the robot '" + space.entities.name[gripped] + "', which this engine cannot hold";
  }
  const bool is_shared = space.structure.grippersOf(gripped).size() > 1;
  return is_shared ? "is not alone in gripping '" + space.entities.name[gripped] + "', which this engine cannot hold"
                   : "";
}

void Kinematics2d::takeOverGrips(const Space& space, BodyIndex index) {
  visitGripsOf(bodies_[index].row, space.structure, [&](Row gripper_row, Row prey_row) {
    const BodyIndex gripper = bodies_.find(gripper_row);
    const BodyIndex prey = bodies_.find(prey_row);
    const bool both_here = gripper != kNoBody && prey != kNoBody && bodies_[gripper].role == Role::kMove &&
                           bodies_[prey].role == Role::kMove;
    if (both_here && motion(gripper).gripped == kNoBody && motion(prey).gripped_by == kNoBody) {
      join(gripper, prey);
    }
  });
}

void Kinematics2d::release(Space& space, BodyIndex gripper_index) {
  const Row gripper = bodies_[gripper_index].row;
  const BodyIndex prey = motion(gripper_index).gripped;
  reportGrip(space, Event::Kind::kReleased, gripper, bodies_[prey].row);
  space.structure.release(gripper);
  motion(prey).gripped_by = kNoBody;
  motion(gripper_index).gripped = kNoBody;
}

void Kinematics2d::forgetGrips(BodyIndex index) {
  Motion& record = motion(index);
  if (record.gripped != kNoBody) {
    motion(record.gripped).gripped_by = kNoBody;
    record.gripped = kNoBody;
  }
  if (record.gripped_by != kNoBody) {
    motion(record.gripped_by).gripped = kNoBody;
    record.gripped_by = kNoBody;
  }
}

}  // namespace swarmanoid::kinematics2d
