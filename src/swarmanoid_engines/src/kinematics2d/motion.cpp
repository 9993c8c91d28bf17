// Phase `move`: integrates velocities to poses without overlap.
#include <algorithm>
#include <cmath>

#include "kinematics2d/kinematics2d.hpp"
#include "planar/body_overlap.hpp"
#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid::kinematics2d {

void Kinematics2d::readMirrors(const Space& space) {
  listBodies();
  mirrors_moved_ = 0.0;
  for (const BodyIndex index : mirrors_) {
    const Body& body = bodies_[index];
    const Eigen::Vector2d position = body.pose.position;
    const double radius = body.model->radius;
    bodies_.place(space, index);
    const double growth = std::max(0.0, body.model->radius - radius);
    mirrors_moved_ = std::max(mirrors_moved_, (body.pose.position - position).norm() + growth);
  }
}

void Kinematics2d::move(const Space& space, const MoveAccess& access, Duration dt) {
  const double tick = toSeconds(dt);
  const double step = tick / subclock_;
  startTick(space, step);
  for (int i = 0; i < subclock_; ++i) {
    travelled_ += step_length_;
    all_.slide_allowance = 0.0;
    moveBlocks(space, access, step, tick);
    visitOthers([&](BodyIndex index) {
      if (!isInGroup(index)) {
        moveBody(index, step, all_);
      } else if (const BodyIndex gripped = motion(index).gripped; motion(gripped).gripped_by == index) {
        moveGroup(gripped, step);
      }
    });
    for (planar::Turret& turret : bodies_.turrets()) {
      turn(turret, step);
    }
    travelled_ += all_.slide_allowance;
  }
  finishTick(space, access, tick);
  finishTurrets(access, tick);
}

void Kinematics2d::startTick(const Space& space, double step) {
  listBodies();
  bodies_.readTurretCommands(space);
  for (const BodyIndex index : idle_) {
    Body& body = bodies_[index];
    motion(index).pose_at_start = {body.pose.position, body.pose.heading};
    body.has_moved = false;
  }
  double fastest_squared = readAllCommands(space);
  bool is_anything_gripped = false;
  for (const BodyIndex index : grippers_) {
    const Body& body = bodies_[index];
    if (motion(index).gripped != kNoBody && body.isDriven()) {
      // a gripped body swings around its gripper
      is_anything_gripped = true;
      const double arm = motion(index).place_of_gripped.position.norm();
      const double speed = body.velocity.norm() + arm * std::abs(body.turn_rate);
      fastest_squared = std::max(fastest_squared, speed * speed);
    }
  }
  const double swing = std::max(startTurrets(step), is_anything_gripped ? fastestOfGroups() : 0.0);
  fastest_squared = std::max(fastest_squared, swing * swing);
  step_length_ = std::sqrt(fastest_squared) * step;
  most_pieces_ = std::max(1.0, std::ceil(step_length_ / (0.5 * smallest_inner_radius_)));
  travelled_ += mirrors_moved_;
  constexpr double kMostTravelled = 1e6;  // m: beyond it, sums would lose too many digits
  if (is_somebody_new_ || !(travelled_ < kMostTravelled)) {
    std::fill(clearances_.begin(), clearances_.end(), Clearance{});
    std::fill(neighbours_.begin(), neighbours_.end(), Neighbours{});
    travelled_ = 0.0;
    is_somebody_new_ = false;
  }
}

/// Number of pieces in a step of a body that searches for neighbours: short enough that it does not tunnel through thin
/// bodies.
int Kinematics2d::piecesOf(const Body& body, double dt) const {
  const double longest = 0.5 * body.model->inner_radius;
  return most_pieces_ == 1.0 ? 1 : std::max(1, static_cast<int>(std::ceil(body.velocity.norm() * dt / longest)));
}

PlacedPose Kinematics2d::unhinderedInPieces(const Body& body, double dt) const {
  const int pieces = piecesOf(body, dt);
  PlacedPose pose = body.pose;
  for (int i = 0; i < pieces; ++i) {
    pose = planar::integrate(pose, body.velocity, body.turn_rate, dt / pieces);
  }
  return pose;
}

void Kinematics2d::moveBody(BodyIndex index, double dt, Block& block) {
  const Body& body = bodies_[index];
  if (body.isCommandedToStand() || moveUnseen(index, dt, block)) {
    return;
  }
  const Eigen::Vector2d start = body.pose.position;
  const int pieces = piecesOf(body, dt);
  for (int i = 0; i < pieces; ++i) {
    movePiece(index, dt / pieces, block);
  }
  // the step length also covers the swing of a gripped body, which adds to the gripper's own way
  const double due = motion(index).gripped == kNoBody ? step_length_ : body.velocity.norm() * dt;
  block.slide_allowance = std::max(block.slide_allowance, (body.pose.position - start).norm() - due);
}

/// Moves a body without a search if its clearance holds. @return whether it has moved
bool Kinematics2d::moveUnseen(BodyIndex index, double dt, const Block& block) {
  if (travelled(block) > clearance(index).free_until) {
    return false;
  }
  put(index, unhindered(bodies_[index], dt), block);
  return true;
}

/// Sets the pose. Until all blocks have moved, the grid keeps the position before.
void Kinematics2d::put(BodyIndex index, const PlacedPose& pose, const Block& block) {
  if (areAllInOne(block)) {
    bodies_.setPose(index, pose);
  } else {
    bodies_.setPoseOnly(index, pose);
  }
}

/// Searches for neighbours. @return whether the body, with the one it grips, is free at the pose; then it has moved
/// there
bool Kinematics2d::tryPose(BodyIndex index, const PlacedPose& pose, const Block& block) {
  const Motion& record = motion(index);
  const BodyIndex gripped = record.gripped;
  planar::Turret* turret = gripped == kNoBody ? nullptr : bodies_.findTurret(index);
  if (turret != nullptr && turret->command.mode == JointCommand::Mode::kPassive) {
    return tryTurned(*turret, pose, trailingAngle(*turret, pose));
  }
  Clearance around = clearance(index);
  if (!isFree(index, pose, around, block)) {
    return false;
  }
  if (gripped != kNoBody) {
    if (!tryCarry(index, pose, record.place_of_gripped)) {
      return false;
    }
    around.free_until = -1.0;  // gripped bodies were skipped; they count as neighbours again after release
  }
  clearance(index) = around;
  put(index, pose, block);
  return true;
}

PlacedPose Kinematics2d::carriedPose(const PlacedPose& gripper, const planar::PlanarPose& place) {
  return PlacedPose::at(gripper.position + gripper.rotated(place.position), wrapAngle(gripper.heading + place.heading));
}

bool Kinematics2d::tryCarry(BodyIndex index, const PlacedPose& pose, const planar::PlanarPose& place) {
  const BodyIndex gripped = motion(index).gripped;
  const PlacedPose carried = carriedPose(pose, place);
  Clearance unused;
  unused.look_ahead = 0.0;
  if (!isFree(gripped, carried, unused, all_)) {
    return false;
  }
  bodies_.setPose(gripped, carried);
  return true;
}

/// Neighbours of a body for a position not far from its current one. Null if there are too many for a list.
const Neighbours* Kinematics2d::neighboursAt(BodyIndex index, const Eigen::Vector2d& position, const Block& block) {
  constexpr float kFewer = 0.7F;
  constexpr float kMore = 1.1F;
  Neighbours& near = neighbours(index);
  const Body& body = bodies_[index];
  const double away = (position - body.pose.position).norm();
  if (near.gapToOthers(travelled(block)) - away > near.leastGap()) {
    return &near;
  }
  SWARMANOID_EXPECTS(areAllInOne(block));  // otherwise cells are not up to date: see knowsWhoIsNear
  const float look = near.look;
  near.count = 0;
  bool has_room = true;
  bodies_.visitNear(position, body.model->radius + look, [&](BodyIndex other) {
    has_room = other == index || near.count < Neighbours::kMost;
    if (other != index && has_room) {
      near.bodies[near.count++] = other;
    }
    return has_room;
  });
  if (has_room) {
    // nearest first: most of the others then need no exact test
    std::sort(near.bodies.begin(), near.bodies.begin() + near.count, [&](BodyIndex a, BodyIndex b) {
      return (bodies_.circle(a).centre - position).squaredNorm() < (bodies_.circle(b).centre - position).squaredNorm();
    });
  }
  near.look = has_room ? std::min(static_cast<float>(kMostLookAhead), kMore * look) : kFewer * look;
  // from now on both sides approach by the distance travelled; some still have this step's way and slide ahead
  near.until = has_room ? freeUntil(look - away - 2.0 * (step_length_ + block.slide_allowance), block) : -1.0;
  return has_room ? &near : nullptr;
}

/// Skips bodies connected by grips.
bool Kinematics2d::isFree(BodyIndex index, const PlacedPose& pose, Clearance& around, const Block& block) {
  const Body& body = bodies_[index];
  const double radius = body.model->radius;
  const Neighbours* near = neighboursAt(index, pose.position, block);
  double nearest = around.look_ahead;
  if (near != nullptr) {
    const double away = (pose.position - body.pose.position).norm();
    nearest = std::max(0.0, near->gapToOthers(travelled(block)) - away);
  }
  if (!areAllInOne(block)) {
    nearest = std::min(nearest, step_length_);  // bodies of other blocks stay farther away: see lookAround
  }
  bool free = true;
  around.at_all_heights = areAllInOne(block);
  visitNear(near, pose.position, radius + nearest, block, [&](BodyIndex other_index) {
    if (other_index == index || bodies_.isFartherThan(other_index, pose.position, radius + std::max(0.0, nearest))) {
      return true;
    }
    const Body& other = bodies_[other_index];
    if (isAtOtherHeights(body, other)) {
      around.at_all_heights = false;
      return true;
    }
    const double gap = bodies_.distanceTo(other_index, pose.position) - radius;
    nearest = std::min(nearest, gap);
    free = gap > 0.0 || areConnected(index, other_index) ||
           !planar::modelsOverlap(*body.model, pose, body.along, other) || !isHindering(index, pose, other);
    return free;
  });
  // From now on both sides approach by the distance travelled; some bodies still have this step's way and slide
  // ahead.
  around.free_until = freeUntil(nearest - step_length_ - block.slide_allowance, block);
  around.look_ahead = lookAheadFor(nearest);
  return free;
}

/// A mirror that was placed onto a body does not hinder it from moving away.
bool Kinematics2d::isHindering(BodyIndex index, const PlacedPose& pose, const Body& other) {
  const Body& body = bodies_[index];
  const bool goes_away =
      (pose.position - other.pose.position).squaredNorm() > (body.pose.position - other.pose.position).squaredNorm();
  return other.role != Role::kMirror || !other.is_movable || !goes_away ||
         !planar::modelsOverlap(*body.model, body.pose, body.along, other);
}

}  // namespace swarmanoid::kinematics2d
