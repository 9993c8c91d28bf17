// Grips: joints that tear, rigid or with a turret. Phase `connect` makes and reports them; they may tear in any step of
// `move`.
#include <algorithm>
#include <cmath>

#include "common/grips.hpp"
#include "dynamics2d/dynamics2d.hpp"
#include "planar/gripper_reach.hpp"

namespace swarmanoid::dynamics2d {

void Dynamics2d::connect(const Space& space, const ConnectAccess& access) {
  for (const BodyIndex index : movers_) {
    const Body& body = bodies_[index];
    if (body.gripper < 0) {
      continue;
    }
    Grip& grip = rigid(index).grip;
    if (grip.is_torn) {
      reportGrip(space, access, Event::Kind::kReleased, body.row, bodies_[grip.gripped].row,
                 tornText(material_.grip_strength));
      access.structure.release(body.row);
      grip = Grip{};
      grip.must_open = true;
    }
    if (!planar::isGripperClosed(space, body)) {
      grip.must_open = false;
      if (grip.isHolding()) {
        reportGrip(space, access, Event::Kind::kReleased, body.row, bodies_[grip.gripped].row);
        access.structure.release(body.row);
        letGo(index);
      }
    } else if (!grip.isHolding() && !grip.must_open) {
      const BodyIndex found = findGrippable(space, index);
      if (found != kNoBody && access.structure.connect(body.row, bodies_[found].row)) {
        hold(index, found);
        reportGrip(space, access, Event::Kind::kAttached, body.row, bodies_[found].row);
      }
    }
  }
}

BodyIndex Dynamics2d::findGrippable(const Space& space, BodyIndex gripper) const {
  return planar::findInReach(bodies_, gripper, [&](BodyIndex index) {
    const Body& body = bodies_[index];
    // a structure is a tree: a robot must not grip a body that hangs on it
    return body.is_movable && body.role == Role::kMove && space.structure.root(body.row) != bodies_[gripper].row;
  });
}

void Dynamics2d::hold(BodyIndex gripper_index, BodyIndex gripped_index) {
  RigidBody& gripper = rigid(gripper_index);
  RigidBody& gripped = rigid(gripped_index);
  const Body& body = bodies_[gripper_index];
  planar::Turret* turret = bodies_.findTurret(gripper_index);
  const planar::PlacedPose& pose = body.pose;
  Eigen::Vector2d pivot = pose.position;
  Grip& grip = gripper.grip;
  grip = Grip{};
  grip.gripped = gripped_index;
  grip.has_turret = turret != nullptr;
  grip.angle = gripped.heading - gripper.heading;
  if (turret != nullptr) {
    turret->held.heading = grip.angle - turret->sense * turret->state.angle;
  } else {
    pivot += pose.rotated(body.entity->gripper->tip * body.model->ahead);
  }
  grip.on_gripper = pose.unrotated(pivot - gripper.centre);
  grip.on_held = bodies_[gripped_index].pose.unrotated(pivot - gripped.centre);
  ++gripped.held_by;
  const auto older = [&](BodyIndex a, BodyIndex b) { return bodies_[a].number < bodies_[b].number; };
  grippers_.insert(std::upper_bound(grippers_.begin(), grippers_.end(), gripper_index, older), gripper_index);
}

void Dynamics2d::letGo(BodyIndex gripper) {
  Grip& grip = rigid(gripper).grip;
  if (grip.isHolding()) {
    --rigid(grip.gripped).held_by;
    grippers_.erase(std::find(grippers_.begin(), grippers_.end(), gripper));
  }
  grip.gripped = kNoBody;
  grip.is_torn = false;
}

void Dynamics2d::forgetGrips(BodyIndex index) {
  letGo(index);
  if (rigid(index).held_by > 0) {
    const std::vector<BodyIndex> grippers = grippers_;
    for (const BodyIndex gripper : grippers) {
      if (rigid(gripper).grip.gripped == index) {
        letGo(gripper);
      }
    }
  }
}

void Dynamics2d::takeOverGrips(const Space& space, BodyIndex index) {
  visitGripsOf(bodies_[index].row, space.structure, [&](Row gripper_row, Row gripped_row) {
    const BodyIndex gripper = bodies_.find(gripper_row);
    const BodyIndex gripped = bodies_.find(gripped_row);
    const auto is_here = [&](BodyIndex i) { return i != kNoBody && bodies_[i].role == Role::kMove; };
    if (is_here(gripper) && is_here(gripped) && bodies_[gripper].entity->gripper && !rigid(gripper).grip.isHolding()) {
      hold(gripper, gripped);
    }
  });
}

void Dynamics2d::tearGrips(double time) {
  for (std::size_t i = 0; i < movable_members_; ++i) {
    const BodyIndex index = members_[i];
    Grip& grip = rigid(index).grip;
    if (!grip.isHolding()) {
      continue;
    }
    const double force = grip.impulse.norm() / time;
    grip.impulse.setZero();
    if (force > material_.grip_strength) {
      --rigid(grip.gripped).held_by;
      grip.is_torn = true;
      grippers_.erase(std::find(grippers_.begin(), grippers_.end(), index));
      const auto is_torn = [&](const GripConstraint& torn) { return torn.gripper == rigid(index).place; };
      island_.grips.erase(std::remove_if(island_.grips.begin(), island_.grips.end(), is_torn), island_.grips.end());
    }
  }
}

}  // namespace swarmanoid::dynamics2d
