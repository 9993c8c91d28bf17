// Phase `connect`: footbots grip preys and let go of them.
#include <cmath>

#include "kinematics2d/kinematics2d.hpp"

namespace swarmanoid::kinematics2d {

void Kinematics2d::connect(Space& space) {
  for (const BodyIndex index : bodies_.order()) {
    const Body& body = bodies_[index];
    if (body.gripper == nullptr || body.role == Role::kMirror) {
      continue;
    }
    if (!body.gripper->closed) {
      if (body.gripped != kNoBody) {
        release(space, index);
      }
    } else if (body.gripped == kNoBody) {
      const BodyIndex prey = findPrey(index);
      if (prey != kNoBody) {
        grip(space, index, prey);
      }
    }
  }
}

BodyIndex Kinematics2d::findPrey(BodyIndex gripper_index) const {
  constexpr double kReach = 0.02;  // m from the gripper's tip to the gripping strip
  const Body& gripper = bodies_[gripper_index];
  const EntityModel::Gripper& geometry = *gripper.entity->gripper;
  const planar::Plane& plane = bodies_.plane();
  const Eigen::Vector3d arm = bodies_.details(gripper_index).base * Eigen::Vector3d(geometry.tip, 0.0, geometry.height);
  const Eigen::Vector2d tip = gripper.pose.position + gripper.pose.rotated(plane.toLocal(arm));
  const double height = gripper.along + plane.along(arm);
  BodyIndex nearest = kNoBody;
  double nearest_distance = kReach;
  bodies_.visitNear(tip, kReach, [&](BodyIndex index) {
    const Body& prey = bodies_[index];
    const EntityModel& entity = *prey.entity;
    const bool is_free_prey = entity.gripping_radius && !entity.is_robot && entity.is_movable &&
                              prey.role == Role::kMove && prey.gripped_by == kNoBody;
    // a strip around a prey that lies is no circle in the plane
    if (!is_free_prey || !plane.isUpright(bodies_.details(index).base) || height < prey.along + prey.model->band.low ||
        height > prey.along + prey.model->band.high) {
      return true;
    }
    const double distance = std::abs((prey.pose.position - tip).norm() - *entity.gripping_radius);
    const bool is_nearer = distance < nearest_distance || (nearest != kNoBody && distance == nearest_distance &&
                                                           prey.number < bodies_[nearest].number);
    if (is_nearer) {
      nearest = index;
      nearest_distance = distance;
    }
    return true;
  });
  return nearest;
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
  Body& gripper = bodies_[gripper_index];
  Body& prey = bodies_[prey_index];
  gripper.gripped = prey_index;
  prey.gripped_by = gripper_index;
  PlanarPose& place = bodies_.details(prey_index).place_in_gripper;
  const Eigen::Vector2d way = prey.pose.position - gripper.pose.position;
  place.position = {gripper.pose.cosine * way.x() + gripper.pose.sine * way.y(),
                    -gripper.pose.sine * way.x() + gripper.pose.cosine * way.y()};
  place.heading = prey.pose.heading - gripper.pose.heading;
}

void Kinematics2d::takeOverGrips(const Space& space, BodyIndex index) {
  const Row row = bodies_[index].row;
  const auto take = [&](BodyIndex gripper, BodyIndex prey) {
    const bool both_here = gripper != kNoBody && prey != kNoBody && bodies_[gripper].role == Role::kMove &&
                           bodies_[prey].role == Role::kMove;
    if (both_here && bodies_[gripper].gripped == kNoBody && bodies_[prey].gripped_by == kNoBody) {
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
  Body& gripper = bodies_[gripper_index];
  const auto& names = space.entities.name;
  space.events.push_back({Event::Kind::kReleased, names[static_cast<std::size_t>(gripper.row)],
                          names[static_cast<std::size_t>(bodies_[gripper.gripped].row)], ""});
  space.structure.release(gripper.row);
  bodies_[gripper.gripped].gripped_by = kNoBody;
  gripper.gripped = kNoBody;
}

void Kinematics2d::forgetGrips(BodyIndex index) {
  Body& body = bodies_[index];
  if (body.gripped != kNoBody) {
    bodies_[body.gripped].gripped_by = kNoBody;
    body.gripped = kNoBody;
  }
  if (body.gripped_by != kNoBody) {
    bodies_[body.gripped_by].gripped = kNoBody;
    body.gripped_by = kNoBody;
  }
}

}  // namespace swarmanoid::kinematics2d
