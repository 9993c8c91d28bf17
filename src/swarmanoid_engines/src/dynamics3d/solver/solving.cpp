// The solvers of a step: from forces to velocities and poses.
#include "dynamics3d/dynamics3d.hpp"
#include "dynamics3d/mechanisms/hanging.hpp"
#include "dynamics3d/mechanisms/rope.hpp"
#include "dynamics3d/solver/islands.hpp"

namespace swarmanoid::dynamics3d {
namespace {

/// Returns whether the body can hang and the current solution moves it. Solvers have separate solutions.
bool isEnabledHolder(const Body& robot) {
  return robot.holding != nullptr && robot.rigid != nullptr && dBodyIsEnabled(robot.rigid) != 0;
}

}  // namespace

void Dynamics3d::solveByIslands(double step) {
  islands_.find(order_, touches_.all());
  counts_.large += islands_.hasLarge() ? 1 : 0;
  if (islands_.hasSmall()) {
    solveSmall(step);
  } else {
    solveOthers(step);
  }
  Islands::forget(order_);
}

void Dynamics3d::solveSmall(double step) {
  if (islands_.hasOthers()) {
    Islands::enableSmall(order_, true);
  }
  const bool is_solved = solveExactly(step);
  counts_.iterative += is_solved ? 0 : 1;
  if (!is_solved) {
    Islands::enableAll(order_);
    solveOthers(step);
  } else if (islands_.hasOthers()) {
    Islands::enableSmall(order_, false);
    solveOthers(step);
  }
  Islands::enableAll(order_);
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
    // after a failure, some contacts have no force in the step
    restoreStates();
  }
  return false;
}

void Dynamics3d::solveOthers(double step) {
  contacts_.make(touches_.all(), step, 0, true);
  contacts_.solveContactIslands(settling_ > 0);
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
    if (isEnabledHolder(*body)) {
      finishHanging(*body);
    }
  }
}

bool Dynamics3d::correctFriction(double step) {
  constexpr int kMostCorrections = 2;
  return correct(step, kMostCorrections, counts_.corrected, [this] { contacts_.markAstray(islands_); });
}

bool Dynamics3d::correctRopes(double step) {
  constexpr int kMostCorrections = 4;
  return correct(step, kMostCorrections, counts_.corrected_ropes, [this, step] { markAstrayRopes(step); });
}

template <class MarkAstray>
bool Dynamics3d::correct(double step, int most, std::uint64_t& count, MarkAstray mark_astray) {
  bool is_solved = true;
  for (int i = 0; i < most && is_solved; ++i) {
    mark_astray();
    if (!islands_.leaveAstray(order_)) {
      break;
    }
    ++count;
    restoreStates();
    contacts_.makeAgain(touches_.all());
    makeRopeJoints(step);
    is_solved = solveContacts(step);
  }
  islands_.reopenSolved(order_);
  return is_solved;
}

void Dynamics3d::markAstrayRopes(double step) {
  for (Body* body : order_) {
    if (!isEnabledHolder(*body)) {
      continue;
    }
    bool are_kept = areHingesKept(*body);
    visitRopes(*body, [&](std::size_t rope) {
      are_kept = (body->holding->ropes[rope].is_broken || isRopeKept(*body, rope, step)) && are_kept;
    });
    if (!are_kept) {
      islands_.markAstray(*body);
    }
  }
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
    if (!isEnabledHolder(*body)) {
      continue;
    }
    prepareHanging(*body, dWorldGetERP(world_));
    visitRopes(*body, [&](std::size_t rope) {
      if (!body->holding->ropes[rope].is_broken) {
        makeRopeJoint(world_, contacts_.joints(), *body, rope, step);
      }
    });
  }
}

}  // namespace swarmanoid::dynamics3d
