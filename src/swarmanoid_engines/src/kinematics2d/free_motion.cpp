// Phase `move`: bodies that cannot meet anybody in a step move first, without looking around, on all threads; and what
// comes of a tick for the space.
//
// The others move after them, one by one, and come where they would have come had all moved one after another by entity
// number: a body moves freely only if it has room for all that others may do in the step, those that are pushed out of
// each other included, so it is in the way of no pose that any of them tries, be it before or after its own move.
#include <algorithm>
#include <cmath>
#include <limits>

#include "kinematics2d/kinematics2d.hpp"
#include "swarmanoid_interface/angle.hpp"

namespace swarmanoid::kinematics2d {

void Kinematics2d::listBodies() {
  if (!are_lists_old_) {
    return;
  }
  are_lists_old_ = false;
  for (auto* list : {&movers_, &idle_, &mirrors_, &grippers_}) {
    list->clear();
  }
  smallest_inner_radius_ = std::numeric_limits<double>::infinity();
  for (const BodyIndex index : bodies_.order()) {
    const Body& body = bodies_[index];
    if (body.role == Role::kMirror) {
      if (body.is_movable) {
        mirrors_.push_back(index);
      }
      continue;
    }
    const bool may_hold = body.gripper >= 0 || motion(index).gripped != kNoBody;  // another engine may have gripped it
    if (body.isDriven() || may_hold) {
      movers_.push_back(index);
    } else if (body.is_movable) {
      idle_.push_back(index);
    }
    if (body.isDriven()) {
      smallest_inner_radius_ = std::min(smallest_inner_radius_, body.model->inner_radius);
    }
    if (may_hold) {
      grippers_.push_back(index);
    }
  }
  others_.resize(movers_.size());
  strays_.resize(movers_.size());
  blocks_.clear();
  constexpr std::size_t kBlock = 512;  // some 100 microseconds of work
  for (std::size_t first = 0; first < movers_.size(); first += kBlock) {
    Block block;
    block.first = first;
    block.last = std::min(first + kBlock, movers_.size());
    blocks_.push_back(block);
  }
}

template <class Work>  // work(block)
void Kinematics2d::forBlocks(Work work) {
  const auto work_on = [&](std::size_t first, std::size_t last) {
    std::for_each(blocks_.begin() + static_cast<std::ptrdiff_t>(first),
                  blocks_.begin() + static_cast<std::ptrdiff_t>(last), work);
  };
  if (workers_ == nullptr) {
    work_on(0, blocks_.size());
  } else {
    workers_->forRanges(blocks_.size(), 1, work_on);
  }
}

/// @return the square of the speed of the fastest [m2/s2]
double Kinematics2d::readAllCommands(const Space& space) {
  forBlocks([&](Block& block) {
    block.fastest_squared = 0.0;
    for (std::size_t k = block.first; k < block.last; ++k) {
      Body& body = bodies_[movers_[k]];
      if (body.isDriven()) {
        readCommands(space, body);
      }
      body.has_moved = false;
      if (subclock_ > 1) {
        motion(movers_[k]).pose_at_start = {body.pose.position, body.pose.heading};
      }
      block.fastest_squared = std::max(block.fastest_squared, body.velocity.squaredNorm());
    }
  });
  double fastest_squared = 0.0;
  for (const Block& block : blocks_) {
    fastest_squared = std::max(fastest_squared, block.fastest_squared);
  }
  return fastest_squared;
}

/// Those whose clearance holds no longer look around, before anybody moves: most find that they have room. Not so who
/// had somebody near when it last looked.
void Kinematics2d::findRoom(double room) {
  const double needed = 2.0 * (room - travelled_ + stride_);  // to the nearest, so that the clearance is that [m]
  forBlocks([&](const Block& block) {
    for (std::size_t k = block.first; k < block.last; ++k) {
      const BodyIndex index = movers_[k];
      const Body& body = bodies_[index];
      const Clearance& around = clearance(index);
      const bool looks = around.free_until < room && around.look_ahead >= lookAheadFor(needed);
      if (looks && !body.isCommandedToStand() && !body.is_large && motion(index).gripped == kNoBody) {
        lookAround(index);
      }
    }
  });
}

void Kinematics2d::lookAround(BodyIndex index) {
  const Body& body = bodies_[index];
  const Neighbours* near = neighboursAt(index, body.pose.position);
  if (near == nullptr) {
    return;
  }
  Clearance& around = clearance(index);
  around.at_all_heights = true;
  double nearest = near->gapToOthers(travelled_) + 2.0 * stride_;
  for (std::size_t i = 0; i < near->count; ++i) {
    const BodyIndex other = near->bodies[i];
    if (bodies_.isFartherThan(other, body.pose.position, body.model->radius + nearest)) {
      continue;
    }
    if (isAtOtherHeights(body, bodies_[other])) {
      around.at_all_heights = false;
    } else {
      nearest = std::min(nearest, bodies_.distanceTo(other, body.pose.position) - body.model->radius);
    }
  }
  // both sides have this step's stride still before them, and later come nearer by what is travelled
  around.free_until = freeUntil(nearest - 2.0 * stride_);
  around.look_ahead = lookAheadFor(nearest);
}

void Kinematics2d::moveFreely(Space& space, double step, double tick) {
  // In each piece of its way, a body that is pushed out may try poses as far beyond its target as that was away, and
  // kMostPush more (contact.cpp): all in all a stride and so many pushes beyond the stride that is counted already.
  const double most_pieces = std::ceil(stride_ / (0.5 * smallest_inner_radius_)) + 1.0;
  const double room = travelled_ + stride_ + most_pieces * kMostPush;
  findRoom(room);
  forBlocks([&](Block& block) { moveFreely(space, step, tick, room, block); });
  // in the order of entity numbers, for the order in which neighbours are found follows from it
  for (const Block& block : blocks_) {
    for (std::size_t k = 0; k < block.stray_count; ++k) {
      bodies_.refreshCell(strays_[block.first + k]);
    }
  }
}

/// @param room what a clearance must hold for who moves freely [m]
void Kinematics2d::moveFreely(Space& space, double step, double tick, double room, Block& block) {
  const bool is_whole_tick = subclock_ == 1;
  block.other_count = 0;
  block.stray_count = 0;
  for (std::size_t k = block.first; k < block.last; ++k) {
    const BodyIndex index = movers_[k];
    Body& body = bodies_[index];
    const planar::PlanarPose before{body.pose.position, body.pose.heading};
    const bool stands = body.isCommandedToStand() && motion(index).gripped == kNoBody;
    const bool has_room = clearance(index).free_until >= room && !body.is_large;  // who grips has none
    if (!body.isDriven() || !(stands || has_room)) {                              // who has no drive may be carried
      others_[block.first + block.other_count++] = index;
      if (is_whole_tick) {
        motion(index).pose_at_start = before;
      }
      continue;
    }
    if (!stands && bodies_.setPoseOnly(index, planar::integrate(body.pose, body.velocity, body.turn_rate, step))) {
      strays_[block.first + block.stray_count++] = index;
    }
    if (is_whole_tick) {
      finishBody(space, index, before, tick);
    }
  }
}

/// What has moved freely for a whole tick is finished.
void Kinematics2d::finishTick(Space& space, double tick) {
  const auto finish = [&](BodyIndex index) { finishBody(space, index, motion(index).pose_at_start, tick); };
  if (subclock_ == 1) {
    visitOthers(finish);
  } else {
    forBlocks([&](const Block& block) {
      std::for_each(movers_.begin() + static_cast<std::ptrdiff_t>(block.first),
                    movers_.begin() + static_cast<std::ptrdiff_t>(block.last), finish);
    });
  }
  std::for_each(idle_.begin(), idle_.end(), finish);
}

void Kinematics2d::finishBody(Space& space, BodyIndex index, const planar::PlanarPose& before, double tick) const {
  const Body& body = bodies_[index];
  if (!body.is_movable) {
    return;
  }
  turnWheels(space, body, tick);
  Twist& twist = space.entities.twist[body.row];
  if (!body.has_moved) {
    twist = Twist{};
    return;
  }
  writePose(space, index, before.heading);
  const planar::Plane& plane = bodies_.plane();
  twist.linear = plane.toGlobal((body.pose.position - before.position) / tick, 0.0);
  twist.angular = plane.normal() * (wrapAngle(body.pose.heading - before.heading) / tick);
}

}  // namespace swarmanoid::kinematics2d
