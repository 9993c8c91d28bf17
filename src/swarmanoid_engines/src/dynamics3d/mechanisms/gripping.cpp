// Phase `connect`: grippers close and open. During `move`, grippers and all other holders measure the force on them,
// and may break.
#include <cmath>
#include <limits>

#include "common/grips.hpp"
#include "dynamics3d/dynamics3d.hpp"
#include "dynamics3d/mechanisms/rope.hpp"

namespace swarmanoid::dynamics3d {
namespace {

/// Distance from a point to the gripping strip around an entity [m]; infinite outside the strip's height.
double distanceToStrip(const Eigen::Vector3d& point, const Body& object) {
  const Eigen::Vector3d local = object.pose.orientation.conjugate() * (point - object.pose.position);
  if (local.z() < object.model->lowest || local.z() > object.model->highest) {
    return std::numeric_limits<double>::infinity();
  }
  return std::abs(std::hypot(local.x(), local.y()) - *object.model->gripping_radius);
}

}  // namespace

void Dynamics3d::connect(const Space& space, const ConnectAccess& access) {
  const OdeLock lock(seed_);
  reportTrouble(access);
  for (Body* body : order_) {
    if (body->holding != nullptr && body->is_dynamic) {
      connectAttachments(space, access, *body);
    }
    if (body->gripper < 0 || !body->is_dynamic) {
      continue;
    }
    Grip& grip = body->grip;
    if (grip.is_broken) {
      release(space, access, *body, tornText(settings_.grip_strength));
      grip.must_open = true;
    }
    if (!space.holder_commands[body->row][static_cast<std::size_t>(body->gripper)].holds) {
      grip.must_open = false;
      if (grip.gripped != nullptr) {
        release(space, access, *body, "");
      }
    } else if (grip.gripped == nullptr && !grip.must_open) {
      if (Body* object = findInReach(space, *body)) {
        this->grip(space, access, *body, *object);
      }
    }
  }
}

Body* Dynamics3d::findInReach(const Space& space, const Body& robot) const {
  const Eigen::Vector3d tip = robot.pose.toWorld(gripperTip(robot));
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(kGripperReach);
  const Body* nearest = nullptr;
  double nearest_distance = kGripperReach;
  seen_.visitNear({tip - reach, tip + reach}, [&](const Body* body, const Eigen::AlignedBox3d&) {
    // a structure is a tree: a robot must not grip a body that hangs on it
    if (body == &robot || !body->is_dynamic || !body->model->gripping_radius ||
        space.structure.root(body->row) == robot.row) {
      return true;
    }
    const double distance = distanceToStrip(tip, *body);
    if (distance < nearest_distance ||
        (nearest != nullptr && distance == nearest_distance && body->number < nearest->number)) {
      nearest = body;
      nearest_distance = distance;
    }
    return true;
  });
  return nearest == nullptr ? nullptr : find(nearest->row);
}

void Dynamics3d::grip(const Space& space, const ConnectAccess& access, Body& robot, Body& object) {
  if (access.structure.connect(robot.row, object.row)) {
    joinGripper(robot, object);
    reportGrip(space, access, Event::Kind::kAttached, robot.row, object.row);
  }
}

void Dynamics3d::joinGripper(Body& robot, Body& object) {
  robot.grip = Grip{};
  robot.grip.holder = robot.rigid;
  if (!robot.turret.isCommanded()) {
    join(robot.grip, object);
    return;
  }
  robot.grip.gripped = &object;
  robot.grip.joint = makeTurretHinge(world_, robot, object);
  dJointSetFeedback(robot.grip.joint, &robot.grip.feedback);
}

void Dynamics3d::join(Grip& grip, Body& object) {
  grip.gripped = &object;
  grip.joint = dJointCreateFixed(world_, nullptr);
  dJointAttach(grip.joint, grip.holder, object.rigid);
  dJointSetFixed(grip.joint);
  dJointSetFeedback(grip.joint, &grip.feedback);
}

void Dynamics3d::takeOverGrips(const Space& space, Body& body) {
  visitGripsOf(body.row, space.structure, [&](Row gripper, Row gripped) {
    Body* robot = find(gripper);
    Body* object = find(gripped);
    if (robot != nullptr && object != nullptr && robot->is_dynamic && object->is_dynamic &&
        robot->grip.gripped == nullptr) {
      joinGripper(*robot, *object);
    }
  });
}

void Dynamics3d::release(const Space& space, const ConnectAccess& access, Body& robot, const std::string& why) {
  reportGrip(space, access, Event::Kind::kReleased, robot.row, robot.grip.gripped->row, why);
  access.structure.release(robot.row);
  letGo(robot.grip);
}

void Dynamics3d::letGo(Grip& grip) {
  if (grip.joint != nullptr) {
    dJointDestroy(grip.joint);
  }
  const bool must_open = grip.must_open;
  grip = Grip{};
  grip.must_open = must_open;
}

void Dynamics3d::forgetHolds(Body& body) {
  for (Body* robot : order_) {
    if (robot == &body || robot->grip.gripped == &body) {
      letGo(robot->grip);
    }
    if (robot->holding == nullptr) {
      continue;
    }
    for (Grip& hold : robot->holding->grips) {
      if (robot == &body || hold.gripped == &body) {
        letGo(hold);
      }
    }
    for (Rope& rope : robot->holding->ropes) {
      if (robot == &body || rope.held == &body) {
        const bool must_rewind = rope.held != nullptr || rope.must_rewind;
        rope = Rope{};
        rope.must_rewind = must_rewind;
      }
    }
  }
}

void Dynamics3d::feelGrips(double step) {
  // The shorter the step, the stronger the force of an impact that lasts one step; only a lasting force breaks a grip.
  constexpr double kLasting = 0.05;  // s
  const double share = 1.0 - std::exp(-step / kLasting);
  for (Body* body : order_) {
    body->pull.setZero();
  }
  const auto feel = [share](Body& robot, Grip& grip, double strength) {
    if (grip.joint == nullptr) {
      return;
    }
    const Eigen::Quaterniond turn = toQuaternion(dBodyGetQuaternion(robot.rigid));
    grip.force += share * (turn.conjugate() * toVector(grip.feedback.f1) - grip.force);
    robot.pull += turn * grip.force;
    grip.gripped->pull -= turn * grip.force;
    if (grip.force.norm() > strength) {
      dJointDestroy(grip.joint);
      grip.joint = nullptr;
      grip.is_broken = true;
    }
  };
  for (Body* body : order_) {
    feel(*body, body->grip, settings_.grip_strength);
    if (body->holding == nullptr) {
      continue;
    }
    for (std::size_t i = 0; i < body->holding->grips.size(); ++i) {
      feel(*body, body->holding->grips[i], strengthOf(body->holder(i).kind));
    }
    for (Rope& rope : body->holding->ropes) {
      if (rope.held != nullptr && !rope.is_broken) {
        feelRope(rope, step, share, settings_.rope_strength);
      }
    }
  }
}

}  // namespace swarmanoid::dynamics3d
