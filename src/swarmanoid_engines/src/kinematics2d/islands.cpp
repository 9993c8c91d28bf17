// Phase `move`: which bodies have room to move freely in a step, and which of the others may meet (islands).
//
// An island that lies in one block moves with it, one body after another by entity number, while other threads move
// other blocks. No other body comes near it in the step, so its bodies reach the poses that they would reach if all
// bodies moved one after another. While blocks move, a thread does not read poses of bodies that move in another block.
#include "kinematics2d/kinematics2d.hpp"

namespace swarmanoid::kinematics2d {

/// Bodies with an expired clearance search for neighbours before the step; most turn out to be free. The others form
/// islands. With a single block no other thread runs, so all islands stay open, and bodies with a near neighbour in
/// their last search do not search again until they move.
void Kinematics2d::findRoom(double room, const Block& block) {
  const bool is_only = blocks_.size() == 1;
  const double most_slide = room - travelled_;  // of any body in a step
  const double look_for_room = is_only ? lookAheadFor(2.0 * (step_length_ + most_slide)) : 0.0;
  islands_.part(block.first, block.last, is_only);
  for (std::size_t k = block.first; k < block.last; ++k) {
    const BodyIndex index = movers_[k];
    if (!hasRoomOrStands(index, room) && clearance(index).look_ahead >= look_for_room) {
      lookAround(k, is_only ? 0.0 : most_slide, block);
    }
  }
}

/// @param slide_allowance upper bound for any body in a step [m]
void Kinematics2d::lookAround(std::size_t k, double slide_allowance, const Block& block) {
  const BodyIndex index = movers_[k];
  const Body& body = bodies_[index];
  if (!movesByItself(body) || isHeldOrHolds(index) || !knowsWhoIsNear(index, slide_allowance)) {
    islands_.open(k);
    return;
  }
  Clearance& around = clearance(index);
  around.at_all_heights = true;
  Neighbours& near = neighbours(index);
  near.meeting = 0;
  const double meeting = 2.0 * (step_length_ + slide_allowance);  // m: only bodies this near can meet in the step
  double nearest = near.gapToOthers(travelled_) + 2.0 * step_length_;
  for (std::size_t i = 0; i < near.count; ++i) {
    const BodyIndex other = near.bodies[i];
    if (bodies_.isFartherThan(other, body.pose.position, body.model->radius + std::max(nearest, meeting))) {
      continue;
    }
    if (isAtOtherHeights(body, bodies_[other])) {
      around.at_all_heights = false;
      continue;
    }
    const double gap = bodies_.distanceTo(other, body.pose.position) - body.model->radius;
    nearest = std::min(nearest, gap);
    if (gap <= meeting) {
      near.meeting = static_cast<std::uint16_t>(near.meeting | (1U << i));
      joinIsland(k, other, block);
    }
  }
  // both sides may still move by this step's length, and later approach by the distance travelled
  around.free_until = freeUntil(nearest - 2.0 * step_length_, all_);
  around.look_ahead = lookAheadFor(nearest);
}

/// Renews the list of neighbours if it would not last for the step. @return whether it lasts now
bool Kinematics2d::knowsWhoIsNear(BodyIndex index, double slide_allowance) {
  const double farthest = step_length_ + slide_allowance;  // way of a body in the step, at most
  const auto lasts = [&](const Neighbours& near) {
    return near.gapToOthers(travelled_) > 2.0 * farthest &&
           near.gapToOthers(travelled_ + slide_allowance) - farthest > near.leastGap();
  };
  Neighbours& near = neighbours(index);
  if (!lasts(near)) {
    near.until = -1.0;
    neighboursAt(index, bodies_[index].pose.position, all_);
  }
  return lasts(near);
}

/// @param k position of a body of the block @param other a body that it may meet; if `other` does not move, nothing is
/// joined
void Kinematics2d::joinIsland(std::size_t k, BodyIndex other, const Block& block) {
  const std::int32_t at = place(other);
  if (isOfOtherBlock(other, block) || isHeldOrHolds(other)) {  // a gripped body may move with another block
    islands_.open(k);
  } else if (at != kNoPlace) {
    islands_.join(k, static_cast<std::size_t>(at));
  }
}

}  // namespace swarmanoid::kinematics2d
