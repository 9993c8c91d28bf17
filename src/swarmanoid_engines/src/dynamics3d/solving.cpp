// The solvers of a step: from forces to velocities and poses.
#include "dynamics3d/dynamics3d.hpp"
#include "dynamics3d/hanging.hpp"
#include "dynamics3d/islands.hpp"
#include "dynamics3d/rope.hpp"

namespace swarmanoid::dynamics3d {
namespace {

/// Whether the last solution moved a body that can hang. Large islands are solved separately.
bool isSolved(const Body& robot) {
  return robot.holding != nullptr && robot.rigid != nullptr && dBodyIsEnabled(robot.rigid) != 0;
}

}  // namespace

void Dynamics3d::solveByIslands(double step) {
  islands_.find(order_, touches_.all());
  counts_.large += islands_.hasLarge() ? 1 : 0;
  if (!islands_.areAllSmall()) {
    Islands::enableSmall(order_, true);
  }
  if (!solveExactly(step)) {
    ++counts_.iterative;
    Islands::enableAll(order_);
    solveIteratively(step);
  } else if (!islands_.areAllSmall()) {
    Islands::enableSmall(order_, false);
    solveIteratively(step);
  }
  Islands::enableAll(order_);
  Islands::forget(order_);
}

bool Dynamics3d::solveExactly(double step) {
  constexpr int kMostAttempts = 3;
  for (Body* body : order_) {
    if (body->island == Body::Island::kSmall) {
      body->saveState();
    }
  }
  for (int attempt = 0; attempt < kMostAttempts; ++attempt) {
    contacts_.make(touches_.all(), step, attempt, false);
    makeRopeJoints(step);
    if (solveContacts(step) && correctFriction(step) && correctRopes(step)) {
      contacts_.keepForces();
      return true;
    }
    counts_.redone += attempt == 0 ? 1 : 0;
    // what is left then is a step in which some contacts hold nothing
    restoreStates();
  }
  return false;
}

void Dynamics3d::solveIteratively(double step) {
  contacts_.make(touches_.all(), step, 0, true);
  contacts_.solveCrowds(settling_ > 0);
  makeRopeJoints(step);
  dWorldQuickStep(world_, step);
  finishSolution();
}

bool Dynamics3d::solveContacts(double step) {
  const long failures = solverFailures();
  dWorldStep(world_, step);
  finishSolution();
  return solverFailures() == failures;
}

void Dynamics3d::finishSolution() {
  contacts_.clear();
  for (Body* body : order_) {
    if (isSolved(*body)) {
      finishHanging(*body);
    }
  }
}

bool Dynamics3d::correctFriction(double step) {
  constexpr int kMostCorrections = 2;
  for (int i = 0; !contacts_.isFrictionCoulombs() && i < kMostCorrections; ++i) {
    ++counts_.corrected;
    restoreStates();
    contacts_.makeAgain(touches_.all());
    makeRopeJoints(step);
    if (!solveContacts(step)) {
      return false;
    }
  }
  return true;
}

bool Dynamics3d::correctRopes(double step) {
  constexpr int kMostCorrections = 4;
  for (int i = 0; i < kMostCorrections && !areRopesKept(step); ++i) {
    ++counts_.corrected_ropes;
    restoreStates();
    contacts_.makeAgain(touches_.all());
    makeRopeJoints(step);
    if (!solveContacts(step)) {
      return false;
    }
  }
  return true;
}

bool Dynamics3d::areRopesKept(double step) {
  bool are_kept = true;
  for (Body* body : order_) {
    if (!isSolved(*body)) {
      continue;
    }
    are_kept = areHingesKept(*body) && are_kept;
    visitRopes(*body, [&](std::size_t rope) {
      are_kept = (body->holding->ropes[rope].is_broken || isRopeKept(*body, rope, step)) && are_kept;
    });
  }
  return are_kept;
}

void Dynamics3d::restoreStates() {
  for (Body* body : order_) {
    if (body->island == Body::Island::kSmall) {
      body->restoreState();
    }
  }
}

void Dynamics3d::makeRopeJoints(double step) {
  for (Body* body : order_) {
    if (body->holding != nullptr) {
      prepareHanging(*body, dWorldGetERP(world_));
    }
    visitRopes(*body, [&](std::size_t rope) {
      if (!body->holding->ropes[rope].is_broken) {
        makeRopeJoint(world_, contacts_.joints(), *body, rope, step);
      }
    });
  }
}

}  // namespace swarmanoid::dynamics3d
