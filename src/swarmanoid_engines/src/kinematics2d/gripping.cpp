// Phase `connect`: footbots grip preys and let go of them.
#include "kinematics2d/kinematics2d.hpp"
#include "planar/gripper_reach.hpp"

namespace swarmanoid::kinematics2d {

void Kinematics2d::connect(Space& space) {
  for (const BodyIndex index : bodies_.order()) {
    const Body& body = bodies_[index];
    if (body.gripper == nullptr || body.role == Role::kMirror) {
      continue;
    }
    if (!body.gripper->closed) {
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
  const Body& gripper = bodies_[gripper_index];
  const Body& prey = bodies_[prey_index];
  if (!space.structure.connect(gripper.row, prey.row)) {
    return;
  }
  join(gripper_index, prey_index);
  const auto& names = space.entities.name;
  space.events.push_back({Event::Kind::kAttached, names[static_cast<std::size_t>(gripper.row)],
                          names[static_cast<std::size_t>(prey.row)], ""});
}

void Kinematics2d::join(BodyIndex gripper_index, BodyIndex prey_index) {
  motion(gripper_index).gripped = prey_index;
  motion(prey_index).gripped_by = gripper_index;
  const PlacedPose& gripper = bodies_[gripper_index].pose;
  const PlacedPose& prey = bodies_[prey_index].pose;
  motion(prey_index).place_in_gripper = {gripper.unrotated(prey.position - gripper.position),
                                         prey.heading - gripper.heading};
}

std::string Kinematics2d::gripRefusal(const Space& space, Row gripper) const {
  const Row gripped = space.structure.grippedBy(gripper);
  const auto i = static_cast<std::size_t>(gripped);
  if (space.entities.model[i]->is_robot) {
    return "grips the robot '" + space.entities.name[i] + "', which this engine cannot hold";
  }
  const bool is_shared = space.structure.grippersOf(gripped).size() > 1;
  return is_shared ? "is not alone in gripping '" + space.entities.name[i] + "', which this engine cannot hold" : "";
}

void Kinematics2d::takeOverGrips(const Space& space, BodyIndex index) {
  const Row row = bodies_[index].row;
  const auto take = [&](BodyIndex gripper, BodyIndex prey) {
    const bool both_here = gripper != kNoBody && prey != kNoBody && bodies_[gripper].role == Role::kMove &&
                           bodies_[prey].role == Role::kMove;
    if (both_here && motion(gripper).gripped == kNoBody && motion(prey).gripped_by == kNoBody) {
      join(gripper, prey);
    }
  };
  const Row gripped = space.structure.grippedBy(row);
  if (gripped != kNoRow) {
    take(index, bodies_.find(gripped));
  }
  for (const Row gripper : space.structure.grippersOf(row)) {
    take(bodies_.find(gripper), index);
  }
}

void Kinematics2d::release(Space& space, BodyIndex gripper_index) {
  const Row gripper = bodies_[gripper_index].row;
  const BodyIndex prey = motion(gripper_index).gripped;
  const auto& names = space.entities.name;
  space.events.push_back({Event::Kind::kReleased, names[static_cast<std::size_t>(gripper)],
                          names[static_cast<std::size_t>(bodies_[prey].row)], ""});
  space.structure.release(gripper);
  motion(prey).gripped_by = kNoBody;
  motion(gripper_index).gripped = kNoBody;
}

void Kinematics2d::forgetGrips(BodyIndex index) {
  Motion& its = motion(index);
  if (its.gripped != kNoBody) {
    motion(its.gripped).gripped_by = kNoBody;
    its.gripped = kNoBody;
  }
  if (its.gripped_by != kNoBody) {
    motion(its.gripped_by).gripped = kNoBody;
    its.gripped_by = kNoBody;
  }
}

}  // namespace swarmanoid::kinematics2d
