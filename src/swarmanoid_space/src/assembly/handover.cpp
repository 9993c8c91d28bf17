#include "handover.hpp"

#include <algorithm>
#include <iterator>

#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid {
namespace {

const ControllerGroup* groupOf(const std::vector<RobotInstance>& instances, Row row) {
  const auto instance = std::find_if(instances.begin(), instances.end(),
                                     [row](const RobotInstance& candidate) { return candidate.row == row; });
  return instance == instances.end() ? nullptr : instance->group;
}

std::string problemOf(const Space& space, const std::vector<RobotInstance>& instances,
                      const std::vector<Membership>& memberships, const std::vector<Row>& members, Row row,
                      const Engine& engine) {
  const EntityModel& model = *space.entities.model[row];
  const Pose& pose = space.entities.pose[row];
  if (!model.is_movable) {
    return "is fixed, no engine moves it";
  }
  const auto posed = posedModel(space.entities.model[row], space.joints[row]);
  std::string problem = engine.invalidPoseReason(*posed, pose);
  if (problem.empty()) {
    problem = unsupportedReasonOf(engine, model, devicesOf(groupOf(instances, row)), memberships);
  }
  if (problem.empty() && space.structure.grippedBy(row) != kNoRow) {
    problem = engine.unsupportedGripReason(space, row);
  }
  if (problem.empty()) {
    problem = engine.unsupportedStateReason(space, row);
  }
  if (problem.empty()) {
    const Row other = engine.overlap(*posed, pose, members);
    problem = other == kNoRow ? "" : "overlaps '" + space.entities.name[other] + "'";
  }
  return problem;
}

/// Whether the device would stand idle in the engine.
bool isIdle(const Engine& engine, const EntityModel& model, const DeviceUse& device) {
  return engine.mayStandIdle(model, device) && !engine.unsupportedReason(model, {device}).empty();
}

/// Takes the entity out of the engine that moves it, and its mirror out of the one that is to. @return the former
Engine* takeOut(Space& space, const std::vector<Membership>& memberships, Row row, const Engine& target) {
  Engine*& mover = space.mover[row];
  for (const Membership& membership : memberships) {
    if (membership.engine == mover || membership.engine == &target) {
      membership.engine->remove(space, row);
    }
  }
  space.entities_without_engine.remove(row);
  Engine* former = mover;
  mover = nullptr;
  return former;
}

/// The roles in which the engines hold the entity from now on.
void changeMemberships(std::vector<Membership>& memberships, const Engine* former, Engine& target) {
  const auto find = [&memberships](const Engine* engine) {
    return std::find_if(memberships.begin(), memberships.end(),
                        [engine](const Membership& membership) { return membership.engine == engine; });
  };
  const auto left = find(former);
  if (left != memberships.end()) {
    left->role = Role::kMirror;
    if (!left->is_listed) {
      memberships.erase(left);
    }
  }
  const auto taken = find(&target);
  if (taken != memberships.end()) {
    taken->role = Role::kMove;
  } else {
    memberships.push_back({&target, Role::kMove, false});
  }
}

}  // namespace

void refreshMirrors(Space& space, const ByRow<std::vector<Membership>>& memberships, Engine& engine) {
  for (const Row row : space.entities.order) {
    for (const Membership& membership : memberships[row]) {
      if (membership.engine == &engine && membership.role == Role::kMirror && space.entities.model[row]->is_movable) {
        engine.place(space, row);
      }
    }
  }
}

std::string unsupportedReasonOf(const Engine& engine, const EntityModel& model, const std::vector<DeviceUse>& devices,
                                const std::vector<Membership>& memberships) {
  std::vector<DeviceUse> needed;
  std::copy_if(devices.begin(), devices.end(), std::back_inserter(needed), [&](const DeviceUse& device) {
    const auto simulatesIt = [&](const Membership& membership) {
      return membership.engine->unsupportedReason(model, {device}).empty();
    };
    return !isIdle(engine, model, device) || std::none_of(memberships.begin(), memberships.end(), simulatesIt);
  });
  return engine.unsupportedReason(model, needed);
}

std::vector<std::string> idleDevices(const Engine& engine, const EntityModel& model,
                                     const std::vector<DeviceUse>& devices) {
  std::vector<std::string> idle;
  for (const DeviceUse& device : devices) {
    if (isIdle(engine, model, device)) {
      idle.push_back(device.type);
    }
  }
  return idle;
}

std::string handoverProblem(const Space& space, const std::vector<RobotInstance>& instances,
                            const ByRow<std::vector<Membership>>& memberships, const std::vector<Row>& members, Row row,
                            const Engine& engine) {
  for (const Row member : members) {
    const std::string problem = problemOf(space, instances, memberships[member], members, member, engine);
    if (!problem.empty()) {
      const std::string who = space.entities.model[member]->type + " '" + space.entities.name[member] + "': ";
      return member == row ? problem : "connected " + who + problem;
    }
  }
  return "";
}

void commitHandover(Space& space, const std::vector<RobotInstance>& instances,
                    ByRow<std::vector<Membership>>& memberships, const std::vector<Row>& members, Engine& engine,
                    std::vector<Event>& events) {
  SWARMANOID_EXPECTS(handoverProblem(space, instances, memberships, members, members.front(), engine).empty());
  std::vector<Engine*> former;
  former.reserve(members.size());
  for (const Row row : members) {
    former.push_back(takeOut(space, memberships[row], row, engine));
  }
  for (std::size_t k = 0; k < members.size(); ++k) {
    const Row row = members[k];
    changeMemberships(memberships[row], former[k], engine);
    space.mover[row] = &engine;
    engine.add(space, row, Role::kMove);
    std::string text = "from " + (former[k] == nullptr ? "no engine" : former[k]->id()) + " to " + engine.id();
    const auto idle = idleDevices(engine, *space.entities.model[row], devicesOf(groupOf(instances, row)));
    text += idle.empty() ? "" : "; idle there: " + joinNames(idle);
    events.push_back({Event::Kind::kHandedOver, space.entities.name[row], "", text});
  }
  // only now, so that no engine has half a structure as mirrors and moves the other half
  for (std::size_t k = 0; k < members.size(); ++k) {
    for (const Membership& membership : memberships[members[k]]) {
      if (membership.engine == former[k]) {
        former[k]->add(space, members[k], Role::kMirror);
      }
    }
  }
}

bool holds(const HandoverDescription& rule, const Space& space, Row row) {
  using Condition = HandoverDescription::Condition;
  using End = HandoverDescription::End;
  const auto isInside = [&] {
    const Eigen::Vector3d& p = space.entities.pose[row].position;
    return (p.array() >= rule.minimum.array()).all() && (p.array() <= rule.maximum.array()).all();
  };
  const auto isAttached = [&] {
    return (rule.end != End::kGripped &&
            (space.structure.grippedBy(row) != kNoRow || space.attachments.isAttached(row))) ||
           (rule.end != End::kGripper && (!space.structure.grippersOf(row).empty() || space.attachments.isHeld(row)));
  };
  const auto isShown = [&] {
    const auto& values = space.robots[row]->debugValues();
    return std::any_of(values.begin(), values.end(), [&rule](const Robot::DebugValue& shown) {
      return shown.first == rule.key && shown.second == rule.value;
    });
  };
  switch (rule.condition) {
    case Condition::kInside:
      return isInside();
    case Condition::kOutside:
      return !isInside();
    case Condition::kAttached:
      return isAttached();
    case Condition::kReleased:
      return !isAttached();
    case Condition::kDebug:
      return isShown();
  }
  return false;
}

}  // namespace swarmanoid
