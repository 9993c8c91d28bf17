// Islands of bodies that may meet in a tick. Mirrors and fixed bodies join no islands: each island has its own copy of
// them.
#include <algorithm>
#include <tuple>

#include "dynamics2d/dynamics2d.hpp"

namespace swarmanoid::dynamics2d {

void Dynamics2d::findNear() {
  near_.clear();
  for (const BodyIndex index : present_) {
    const Body& body = bodies_[index];
    const RigidBody& rigid_body = rigid(index);
    const Eigen::Vector2d& centre = body.pose.position;
    bodies_.visitNear(centre, body.model->radius + rigid_body.way + longest_way_, [&](BodyIndex other_index) {
      const Body& other = bodies_[other_index];
      const RigidBody& reached = rigid(other_index);
      const bool moves = other.is_movable && other.role == Role::kMove;
      if (other_index == index || (moves && (!reached.is_present || other.number < body.number)) ||
          !body.model->band.overlaps(other.model->band, body.along, other.along)) {
        return true;
      }
      const bool is_held = (rigid_body.grip.isHolding() && rigid_body.grip.gripped == other_index) ||
                           (reached.grip.isHolding() && reached.grip.gripped == index);
      const double gap = bodies_.distanceTo(other_index, centre) - body.model->radius;
      if (!is_held && gap <= rigid_body.way + reached.way) {
        near_.emplace_back(index, other_index);
      }
      return true;
    });
  }
}

int Dynamics2d::rootOf(int rank) {
  int root = rank;
  while (roots_[static_cast<std::size_t>(root)] != root) {
    root = roots_[static_cast<std::size_t>(root)];
  }
  while (roots_[static_cast<std::size_t>(rank)] != root) {
    rank = std::exchange(roots_[static_cast<std::size_t>(rank)], root);
  }
  return root;
}

void Dynamics2d::joinIslands() {
  roots_.resize(present_.size());
  for (std::size_t i = 0; i < roots_.size(); ++i) {
    roots_[i] = static_cast<int>(i);
  }
  const auto join = [&](BodyIndex a, BodyIndex b) {
    const int root_a = rootOf(rigid(a).rank);
    const int root_b = rootOf(rigid(b).rank);
    roots_[static_cast<std::size_t>(std::max(root_a, root_b))] = std::min(root_a, root_b);
  };
  for (const auto& [first, second] : near_) {
    if (rigid(second).is_present) {
      join(first, second);
    }
  }
  for (const BodyIndex gripper : grippers_) {
    join(gripper, rigid(gripper).grip.gripped);
  }
}

void Dynamics2d::moveIslands(double tick) {
  contacts_.clear();
  if (present_.empty()) {
    return;
  }
  findNear();
  joinIslands();
  order_of_islands_.clear();
  for (std::size_t i = 0; i < present_.size(); ++i) {
    order_of_islands_.emplace_back(rootOf(static_cast<int>(i)), static_cast<int>(i));
  }
  std::sort(order_of_islands_.begin(), order_of_islands_.end());
  const auto rootOfNear = [&](const Near& near) { return rootOf(rigid(near.first).rank); };
  // by entity numbers, since the order in the grid depends on when bodies came into a cell
  std::sort(near_.begin(), near_.end(), [&](const Near& a, const Near& b) {
    const auto key = [&](const Near& near) {
      return std::make_tuple(rootOfNear(near), bodies_[near.first].number, bodies_[near.second].number);
    };
    return key(a) < key(b);
  });
  auto near = near_.cbegin();
  for (std::size_t i = 0; i < order_of_islands_.size();) {
    const int root = order_of_islands_[i].first;
    members_.clear();
    near_of_island_.clear();
    for (; i < order_of_islands_.size() && order_of_islands_[i].first == root; ++i) {
      members_.push_back(present_[static_cast<std::size_t>(order_of_islands_[i].second)]);
    }
    for (; near != near_.cend() && rootOfNear(*near) == root; ++near) {
      near_of_island_.push_back(*near);
    }
    moveIsland(tick);
  }
}

}  // namespace swarmanoid::dynamics2d
