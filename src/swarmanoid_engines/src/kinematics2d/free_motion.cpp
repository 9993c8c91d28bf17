// Phase `move`: bodies that cannot meet others in a step move without a search for neighbours, on all threads. Also the
// results of a tick for the space.
//
// The other bodies move one by one, with these or after them (islands.cpp), and reach the poses that they would reach
// if all bodies moved one after another by entity number. Therefore a body moves freely only if it has room for all
// that others may do in the step, pushes out of overlaps included: it then blocks no pose that any of them tries,
// before or after its own move.
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
  islands_.resize(movers_.size());
  listBlocks();
}

void Kinematics2d::listBlocks() {
  places_.assign(motions_.size(), kNoPlace);
  for (std::size_t k = 0; k < movers_.size(); ++k) {
    places_[static_cast<std::size_t>(movers_[k])] = static_cast<std::int32_t>(k);
  }
  all_ = Block{};
  all_.last = movers_.size();
  const std::size_t threads = workers_ == nullptr ? 1 : workers_->threads();
  const std::size_t size = std::max(least_block_, (movers_.size() + threads - 1) / threads);
  blocks_.clear();
  for (std::size_t first = 0; first < movers_.size(); first += size) {
    Block block;
    block.first = first;
    block.last = std::min(first + size, movers_.size());
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

/// @return square of the largest speed [m2/s2]
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

void Kinematics2d::moveBlocks(const Space& space, const MoveAccess& access, double step, double tick) {
  // In each piece of its way, a body that is pushed out may try poses beyond its target, by the length of the piece and
  // kMostPush more (contact.cpp). In total that is a step length and most_pieces_ pushes beyond the step length that is
  // counted already.
  const bool is_in_turn = least_block_ == 0;
  const double room =
      is_in_turn ? std::numeric_limits<double>::infinity() : travelled_ + step_length_ + most_pieces_ * kMostPush;
  forBlocks([&](const Block& block) { findRoom(room, block); });
  forBlocks([&](Block& block) { moveBlock(space, access, step, tick, room, block); });
  for (const Block& block : blocks_) {
    all_.slide_allowance = std::max(all_.slide_allowance, block.slide_allowance);
    // other bodies change cells later, when they move: the order within a cell depends on blocks, so results must not
    // depend on it
    for (std::size_t k = 0; k < block.stray_count; ++k) {
      bodies_.refreshCell(strays_[block.first + k]);
    }
  }
}

void Kinematics2d::moveBlock(const Space& space, const MoveAccess& access, double step, double tick, double room,
                             Block& block) {
  const bool is_whole_tick = subclock_ == 1;
  block.slide_allowance = 0.0;
  block.other_count = 0;
  block.stray_count = 0;
  for (std::size_t k = block.first; k < block.last; ++k) {
    const BodyIndex index = movers_[k];
    Body& body = bodies_[index];
    const planar::PlanarPose before{body.pose.position, body.pose.heading};
    const bool moves_freely = hasRoomOrStands(index, room);
    if (!movesByItself(body) || (!moves_freely && islands_.isOpen(k))) {
      others_[block.first + block.other_count++] = index;
      if (is_whole_tick) {
        motion(index).pose_at_start = before;
      }
      continue;
    }
    if (!moves_freely) {
      moveBody(index, step, block);
    } else if (!body.isCommandedToStand()) {
      bodies_.setPoseOnly(index, unhindered(body, step));
    }
    if (bodies_.isInOtherCell(index)) {
      strays_[block.first + block.stray_count++] = index;
    }
    if (is_whole_tick) {
      finishBody(space, access, index, before, tick);
    }
  }
}

/// Finishes the bodies of a tick. With one step a tick, bodies that moved with their block are finished already.
void Kinematics2d::finishTick(const Space& space, const MoveAccess& access, double tick) {
  const auto finish = [&](BodyIndex index) { finishBody(space, access, index, motion(index).pose_at_start, tick); };
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

void Kinematics2d::finishBody(const Space& space, const MoveAccess& access, BodyIndex index,
                              const planar::PlanarPose& before, double tick) const {
  const Body& body = bodies_[index];
  if (!body.is_movable) {
    return;
  }
  turnWheels(space, access, body, tick);
  Twist& twist = access.twist[body.row];
  if (!body.has_moved) {
    twist = Twist{};
    return;
  }
  writePose(access, index, before.heading);
  const planar::Plane& plane = bodies_.plane();
  const double turn = wrapAngle(body.pose.heading - before.heading);
  const Eigen::Vector2d mean = (body.pose.position - before.position) / tick;
  twist.linear = plane.toGlobal(planar::velocityAtEnd(mean, turn), 0.0);
  twist.angular = plane.normal() * (turn / tick);
}

}  // namespace swarmanoid::kinematics2d
