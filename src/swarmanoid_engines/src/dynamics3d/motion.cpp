// Phase `move`: from commands and forces to poses.
#include <algorithm>

#include "dynamics3d/dynamics3d.hpp"
#include "dynamics3d/mechanisms/arms.hpp"
#include "dynamics3d/mechanisms/flight.hpp"
#include "dynamics3d/mechanisms/rope.hpp"
#include "dynamics3d/mechanisms/treels.hpp"
#include "dynamics3d/steady_motion.hpp"
#include "swarmanoid_space/access.hpp"

namespace swarmanoid::dynamics3d {

void Dynamics3d::readMirrors(const Space& space) {
  const OdeLock lock(seed_);
  for (Body* body : order_) {
    if (body->rigid != nullptr && !body->is_dynamic) {
      takePose(space, *body);
    }
  }
}

void Dynamics3d::move(const Space& space, const MoveAccess& access, Duration dt) {
  const OdeLock lock(seed_);
  if (world_ == nullptr) {
    return;
  }
  for (Body* body : order_) {
    if (body->is_dynamic) {
      readCommands(space, *body);
      body->treels.run[0] = 0.0;
      body->treels.run[1] = 0.0;
    }
  }
  leaveOutSteady(toSeconds(dt));
  const double step = toSeconds(dt) / settings_.subclock;
  for (int i = 0; i < settings_.subclock; ++i) {
    stepOnce(i, step);
  }
  for (Body* body : left_out_) {
    takeIn(*body, settings_.subclock, step);
  }
  finishTick(access);
}

namespace {

/// Whether a flying robot hangs by its magnet, and need not fly, which saves its battery.
bool hangsByMagnet(const Body& robot) {
  for (std::size_t i = 0; robot.holding != nullptr && i < robot.holding->grips.size(); ++i) {
    if (robot.holder(i).kind == EntityModel::Holder::Kind::kMagnet && robot.holding->grips[i].joint != nullptr) {
      return true;
    }
  }
  return false;
}

}  // namespace

void Dynamics3d::leaveOutSteady(double tick) {
  noteRopes();
  left_out_.clear();
  if (settling_ > 0 || keeps_all_in_ode_) {
    return;
  }
  for (Body* body : order_) {
    if (!body->is_dynamic || !movesSteadily(*body)) {
      continue;
    }
    body->steadiness.box = boxAroundWay(*body, Touches::boundsNow(*body), tick);
    if (!ground_.isRoughAt(body->steadiness.box)) {
      body->steadiness.is_left_out = true;
      dBodyDisable(body->rigid);
      left_out_.push_back(body);
    }
  }
}

void Dynamics3d::takeInReached(int steps, double step) {
  for (Body* body : touches_.findPairs(order_.size())) {
    takeIn(*body, steps, step);
    Touches::boundsNow(*body);
  }
}

void Dynamics3d::takeIn(Body& body, int steps, double step) {
  if (!body.steadiness.is_left_out) {
    return;
  }
  body.steadiness.is_left_out = false;
  dBodyEnable(body.rigid);
  if (steps > 0) {
    moveOn(body, steps, step);
  }
}

void Dynamics3d::stepOnce(int number, double step) {
  for (Body* body : order_) {
    if (!body->is_dynamic) {
      continue;
    }
    if (body->model->wheels) {
      followCommand(*body, step);
      if (recorded_treels_ != nullptr) {
        recorded_treels_->push_back(body->treels);
      }
    }
    if (body->steadiness.is_left_out) {
      continue;
    }
    if (body->flight_command.is_driven && !hangsByMagnet(*body)) {
      fly(*body, settings_.gravity, step);
    }
    driveLinks(*body);
    visitRopes(*body, [&](std::size_t rope) {
      windRope(*body, rope, step);
      dragRope(*body, rope, settings_.rope_drag);
    });
    driveTurret(*body, touches_, step);
  }
  takeInReached(number, step);
  setDamping(settling_ == 0);
  ++counts_.steps;
  touches_.find(order_);
  contacts_.startStep(order_.size());
  if (settings_.solver == Settings::Solver::kIterative) {
    solveOthers(step);
  } else {
    solveByIslands(step);
  }
  contacts_.finishStep();
  setDamping(true);
  settling_ = std::max(settling_ - 1, 0);
  for (Body* body : order_) {
    if (body->isInOde()) {
      readTurret(*body);
      noteStep(*body, step);
      ++counts_.moved;
    }
  }
  noteRopes();
  feelGrips(step);
}

void Dynamics3d::noteRopes() {
  for (Body* body : order_) {
    visitRopes(*body, [&](std::size_t rope) { body->holding->ropes[rope].held->steadiness.time = 0.0; });
  }
}

void Dynamics3d::setDamping(bool is_damped) {
  // Contacts carry a load by a penetration of parts of a micrometre, which takes some ten steps to build up. Placed
  // bodies must stand at once, since a grip that is closed meanwhile would keep the missing part as a force: so at
  // first contacts are as stiff as ever, but not damped.
  dWorldSetERP(world_, is_damped ? kErrorReduction : 1.0);
  dWorldSetCFM(world_, is_damped ? kSoftness : kSoftness / kErrorReduction);
}

void Dynamics3d::reportTrouble(const ConnectAccess& access) {
  if (counts_.large > 0 && !has_reported_islands_) {
    has_reported_islands_ = true;
    access.events.push_back(
        {Event::Kind::kEngineTrouble, "", "",
         "dynamics3d '" + id_ + "': " + std::to_string(islands_.largestEver()) +
             " bodies touch, which is too many for an exact solution: forces spread among them over "
             "some steps; from now on this is only counted"});
  }
  if (counts_.iterative > 0 && !has_reported_trouble_) {
    has_reported_trouble_ = true;
    access.events.push_back({Event::Kind::kEngineTrouble, "", "",
                             "dynamics3d '" + id_ +
                                 "': the exact solver gave up, the iterative one made the step; from now on this is "
                                 "only counted"});
  }
}

EngineHealth Dynamics3d::health() const {
  EngineHealth health;
  health.steps_per_tick = settings_.subclock;
  health.counters = {{"steps", std::to_string(counts_.steps)},
                     {"bodies moved in them", std::to_string(counts_.moved)},
                     {"steps solved again for friction", std::to_string(counts_.corrected)},
                     {"steps solved again for ropes", std::to_string(counts_.corrected_ropes)},
                     {"steps redone", std::to_string(counts_.redone)},
                     {"steps left to the iterative solver", std::to_string(counts_.iterative)},
                     {"steps with large islands", std::to_string(counts_.large)}};
  if (counts_.iterative > 0) {
    health.warning = "the exact solver gave up in " + std::to_string(counts_.iterative) + " steps";
  }
  return health;
}

void Dynamics3d::finishTick(const MoveAccess& access) {
  for (Body* body : order_) {
    if (body->is_dynamic) {
      body->pose = body->currentPose();
      access.pose[body->row] = body->pose;
      access.twist[body->row] = body->currentTwist();
      if (body->model->wheels) {
        turnWheels(*body, access.wheel_turns[body->row]);
      }
      if (!body->links.empty()) {
        readLinks(*body, access.joints[body->row]);
        body->poseShapes(access.joints[body->row]);
      }
      if (body->turret.isCommanded()) {
        access.joints[body->row][body->turret.joint] = body->turret.state;
        body->poseShapes(access.joints[body->row]);
      }
    }
  }
  seen_.update([](const Body* body) { return boundsOf(body->seen(), body->pose); });
}

}  // namespace swarmanoid::dynamics3d
