#include "dynamics3d/solver/islands.hpp"

#include <algorithm>
#include <numeric>

#include "dynamics3d/mechanisms/rope.hpp"
#include "dynamics3d/solver/momentum_balance.hpp"

namespace swarmanoid::dynamics3d {
namespace {

/// Whether the body takes part in the step; mirrors do.
bool isStepped(const Body& body) { return body.rigid != nullptr && !body.steadiness.is_left_out; }

template <class Visit>
void visitStepped(const std::vector<Body*>& bodies, Visit visit) {
  for (Body* body : bodies) {
    if (isStepped(*body)) {
      visit(*body);
    }
  }
}

void setEnabled(Body& body, bool is_enabled) {
  const auto set = [is_enabled](dBodyID rigid) { is_enabled ? dBodyEnable(rigid) : dBodyDisable(rigid); };
  set(body.rigid);
  for (const Link& link : body.links) {
    set(link.rigid);
  }
}

std::size_t placeOf(const Body& body) { return static_cast<std::size_t>(body.rank); }

}  // namespace

void Islands::find(const std::vector<Body*>& bodies, const std::vector<Touch>& touches) {
  largest_ = 0;
  has_small_ = false;
  has_others_ = false;
  parents_.resize(bodies.size());
  std::iota(parents_.begin(), parents_.end(), 0);
  islands_.assign(bodies.size(), Island{});
  is_astray_.assign(bodies.size(), 0);
  for (const Touch& touch : touches) {
    if (touch.b != nullptr && isStepped(*touch.b)) {
      join(*touch.a, *touch.b);
    }
  }
  visitStepped(bodies, [this](Body& body) { joinHeld(body); });
  visitStepped(bodies, [this](Body& body) {
    Island& island = islands_[rootOf(placeOf(body))];
    ++island.bodies;
    island.has_links = island.has_links || !body.links.empty();
  });
  for (const Touch& touch : touches) {
    ++islands_[rootOf(placeOf(*touch.a))].joints;
  }
  visitStepped(bodies, [this](Body& body) {
    const std::size_t root = rootOf(placeOf(body));
    const Island& island = islands_[root];
    body.island = solverOf(island);
    body.island_first = static_cast<int>(root);
    (body.island == Body::Island::kSmall ? has_small_ : has_others_) = true;
    if (isLarge(island)) {
      largest_ = std::max(largest_, island.bodies);
    }
  });
  largest_ever_ = std::max(largest_ever_, largest_);
}

bool Islands::isLarge(const Island& island) {
  constexpr int kMostJoints = 64;            // some eight footbots pressed together
  constexpr int kMostJointsOfGripped = 256;  // larger, since the iterative solver makes grip forces rough
  if (island.bodies <= static_cast<int>(kMostNewtonBodies) && !island.has_links && !island.has_grips) {
    return false;
  }
  return island.joints > (island.has_grips ? kMostJointsOfGripped : kMostJoints);
}

Body::Island Islands::solverOf(const Island& island) {
  if (!island.has_links && !island.has_grips) {
    return Body::Island::kContacts;
  }
  return isLarge(island) ? Body::Island::kLarge : Body::Island::kSmall;
}

std::size_t Islands::rootOf(std::size_t rank) {
  while (parents_[rank] != rank) {
    parents_[rank] = parents_[parents_[rank]];  // path halving
    rank = parents_[rank];
  }
  return rank;
}

void Islands::join(const Body& a, const Body& b) {
  const std::size_t root_a = rootOf(placeOf(a));
  const std::size_t root_b = rootOf(placeOf(b));
  if (root_a == root_b) {
    return;
  }
  const std::size_t root = std::min(root_a, root_b);
  const std::size_t other = std::max(root_a, root_b);
  parents_[other] = root;
  islands_[root].joints += islands_[other].joints;
  islands_[root].has_grips = islands_[root].has_grips || islands_[other].has_grips;
}

void Islands::joinHeld(Body& body) {
  joinBy(body, body.rigid);
  for (const Link& link : body.links) {
    joinBy(body, link.rigid);
  }
  visitRopes(body, [&](std::size_t index) {
    const Rope& rope = body.holding->ropes[index];
    if (rope.is_broken) {
      return;
    }
    if (isStepped(*rope.held)) {
      join(body, *rope.held);
    }
    Island& island = islands_[rootOf(placeOf(body))];
    ++island.joints;
    island.has_grips = true;
  });
}

void Islands::joinBy(Body& body, dBodyID rigid) {
  const int count = dBodyGetNumJoints(rigid);
  for (int i = 0; i < count; ++i) {
    const dJointID joint = dBodyGetJoint(rigid, i);
    // each joint between two bodies is visited twice
    islands_[rootOf(placeOf(body))].joints += dJointGetBody(joint, 0) == rigid ? 1 : 0;
    for (int side = 0; side < 2; ++side) {
      const dBodyID other_rigid = dJointGetBody(joint, side);
      if (other_rigid == rigid) {
        continue;
      }
      if (other_rigid == nullptr) {  // it holds a fixed entity
        islands_[rootOf(placeOf(body))].has_grips = true;
        continue;
      }
      const auto& other = *static_cast<const Body*>(dBodyGetData(other_rigid));
      join(body, other);
      Island& island = islands_[rootOf(placeOf(body))];
      island.has_grips = island.has_grips || &other != &body;
    }
  }
}

bool Islands::leaveAstray(const std::vector<Body*>& bodies) {
  bool is_any_astray = false;
  visitStepped(bodies, [&](Body& body) {
    if (body.island != Body::Island::kSmall) {
      return;
    }
    if (is_astray_[static_cast<std::size_t>(body.island_first)] != 0) {
      is_any_astray = true;
      return;
    }
    body.island = Body::Island::kSolved;
    setEnabled(body, false);
  });
  std::fill(is_astray_.begin(), is_astray_.end(), 0);
  return is_any_astray;
}

void Islands::reopenSolved(const std::vector<Body*>& bodies) {
  visitStepped(bodies, [](Body& body) {
    if (body.island == Body::Island::kSolved) {
      body.island = Body::Island::kSmall;
      setEnabled(body, true);
    }
  });
}

void Islands::enableSmall(const std::vector<Body*>& bodies, bool is_small) {
  visitStepped(bodies, [is_small](Body& body) { setEnabled(body, (body.island == Body::Island::kSmall) == is_small); });
}

void Islands::enableAll(const std::vector<Body*>& bodies) {
  visitStepped(bodies, [](Body& body) { setEnabled(body, true); });
}

void Islands::forget(const std::vector<Body*>& bodies) {
  for (Body* body : bodies) {
    body->island = Body::Island::kNone;
  }
}

}  // namespace swarmanoid::dynamics3d
