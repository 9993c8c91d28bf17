// Phase `move`: who has room to move freely in a step; and who may meet whom, of those that have not.
//
// A huddle that lies in one block moves with it, one after another by entity number, while other threads move other
// blocks: nobody else comes near it in the step, so all of it come where they would have come had all moved one after
// another. While blocks move, a thread reads no pose of what moves in another one.
#include "kinematics2d/kinematics2d.hpp"

namespace swarmanoid::kinematics2d {

/// Those whose clearance holds no longer look around, before anybody moves: most find that they have room. The others
/// are in huddles; not so where all are one block, which nobody else moves beside: then all huddles are open, and who
/// had somebody near when it last looked does so only when it moves.
void Kinematics2d::findRoom(double room, const Block& block) {
  const bool is_only = blocks_.size() == 1;
  const double most_detour = room - travelled_;  // of a body in a step
  const double look_for_room = is_only ? lookAheadFor(2.0 * (stride_ + most_detour)) : 0.0;
  huddles_.part(block.first, block.last, is_only);
  for (std::size_t k = block.first; k < block.last; ++k) {
    const BodyIndex index = movers_[k];
    if (!hasRoomOrStands(index, room) && clearance(index).look_ahead >= look_for_room) {
      lookAround(k, is_only ? 0.0 : most_detour, block);
    }
  }
}

/// @param detour of a body in a step, at most [m]
void Kinematics2d::lookAround(std::size_t k, double detour, const Block& block) {
  const BodyIndex index = movers_[k];
  const Body& body = bodies_[index];
  if (!movesByItself(body) || isHeldOrHolds(index) || !knowsWhoIsNear(index, detour)) {
    huddles_.open(k);
    return;
  }
  Clearance& around = clearance(index);
  around.at_all_heights = true;
  Neighbours& near = neighbours(index);
  near.meeting = 0;
  const double meeting = 2.0 * (stride_ + detour);  // from so far away two may meet, m
  double nearest = near.gapToOthers(travelled_) + 2.0 * stride_;
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
      joinHuddle(k, other, block);
    }
  }
  // both sides have this step's stride still before them, and later come nearer by what is travelled
  around.free_until = freeUntil(nearest - 2.0 * stride_, all_);
  around.look_ahead = lookAheadFor(nearest);
}

/// Lists anew who is near where a list would not last for the step. @return whether it lasts now
bool Kinematics2d::knowsWhoIsNear(BodyIndex index, double detour) {
  const double farthest = stride_ + detour;  // that a body comes
  const auto lasts = [&](const Neighbours& near) {
    return near.gapToOthers(travelled_) > 2.0 * farthest &&
           near.gapToOthers(travelled_ + detour) - farthest > near.leastGap();
  };
  Neighbours& near = neighbours(index);
  if (!lasts(near)) {
    near.until = -1.0;
    neighboursAt(index, bodies_[index].pose.position, all_);
  }
  return lasts(near);
}

/// @param k one of the block @param other a body that it may meet; or that stands where it is, and joins nothing
void Kinematics2d::joinHuddle(std::size_t k, BodyIndex other, const Block& block) {
  const std::int32_t at = place(other);
  if (isOfOtherBlock(other, block) || isHeldOrHolds(other)) {  // what is held may be by somebody of another block
    huddles_.open(k);
  } else if (at != kNoPlace) {
    huddles_.join(k, static_cast<std::size_t>(at));
  }
}

}  // namespace swarmanoid::kinematics2d
