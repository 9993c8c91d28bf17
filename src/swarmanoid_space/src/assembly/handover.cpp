#include "handover.hpp"

#include <algorithm>
#include <iterator>

#include "find_overlap.hpp"
#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid {
namespace {

const ControllerGroup* groupOf(const std::vector<RobotInstance>& instances, Row row) {
  const auto instance = std::find_if(instances.begin(), instances.end(),
                                     [row](const RobotInstance& candidate) { return candidate.row == row; });
  return instance == instances.end() ? nullptr : instance->group;
}

/// Returns whether the device would stand idle in the engine.
bool isIdle(const Engine& engine, const EntityModel& model, const DeviceUse& device) {
  return engine.mayStandIdle(model, device) && !engine.unsupportedReason(model, {device}).empty();
}

/// Updates the roles of the entity in the engines after a handover.
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

template <class Action>
auto Handover::call(const char* phase, const Engine& engine, Action action) const {
  return callPlugin(phase, partOf(engines_, engine), space_.tick, action);
}

Handover::Handover(const Space& space, const HandOverAccess& access, const std::vector<Named<Engine>>& engines,
                   const std::vector<RobotInstance>& instances, ByRow<std::vector<Membership>>& memberships, Row row,
                   Engine& target)
    : space_(space),
      access_(access),
      engines_(engines),
      instances_(instances),
      memberships_(memberships),
      row_(row),
      target_(target),
      members_(connectedTo(space.entities, space.structure, space.attachments, row)) {
  for (const Row other : space.entities.order) {
    for (const Membership& membership : memberships[other]) {
      if (membership.engine == &target && membership.role == Role::kMirror && space.entities.model[other]->is_movable) {
        mirrors_.push_back(other);
      }
    }
  }
}

std::string Handover::problem() const {
  for (const Row member : members_) {
    const std::string problem = call("handover", target_, [&] { return problemOf(member); });
    if (!problem.empty()) {
      const std::string who = space_.entities.model[member]->type + " '" + space_.entities.name[member] + "': ";
      return member == row_ ? problem : "connected " + who + problem;
    }
  }
  return "";
}

std::string Handover::problemOf(Row member) const {
  const EntityModel& model = *space_.entities.model[member];
  const Pose& pose = space_.entities.pose[member];
  if (!model.is_movable) {
    return "is fixed, no engine moves it";
  }
  const auto posed = posedModel(space_.entities.model[member], space_.joints[member]);
  std::string problem = target_.invalidPoseReason(*posed, pose);
  if (problem.empty()) {
    problem = unsupportedReasonOf(target_, model, devicesOf(groupOf(instances_, member)), memberships_[member]);
  }
  if (problem.empty()) {
    problem = target_.unsupportedStateReason(space_, member);
  }
  if (problem.empty()) {
    const Row other = overlapOf(*posed, pose);
    problem = other == kNoRow ? "" : "overlaps '" + space_.entities.name[other] + "'";
  }
  return problem;
}

Row Handover::overlapOf(const EntityModel& posed, const Pose& pose) const {
  // the target has the poses of its mirrors from one tick ago; the engines that move them have the present ones
  std::vector<Row> ignored = members_;
  std::copy_if(mirrors_.begin(), mirrors_.end(), std::back_inserter(ignored),
               [&](Row mirror) { return space_.mover[mirror] != nullptr; });
  Row found = target_.overlap(posed, pose, ignored);
  for (const Named<Engine>& engine : engines_) {
    const auto counts = [&](Row other) {
      return space_.mover[other] == engine.get() &&
             std::find(mirrors_.begin(), mirrors_.end(), other) != mirrors_.end();
    };
    const Row other = engine.get() == &target_ ? kNoRow : call("handover", *engine, [&] {
      return findOverlap(*engine, posed, pose, members_, counts);
    });
    if (other != kNoRow && (found == kNoRow || space_.entities.number[other] < space_.entities.number[found])) {
      found = other;
    }
  }
  return found;
}

/// Removes the entity from the engine that moves it, and its mirror from the target. @return the former engine
Engine* Handover::takeOut(Row member) {
  const Engine*& mover = access_.mover[member];
  Engine* former = nullptr;
  for (const Membership& membership : memberships_[member]) {
    if (membership.engine == mover) {
      former = membership.engine;
    }
    if (membership.engine == mover || membership.engine == &target_) {
      call("remove", *membership.engine, [&] { membership.engine->remove(space_, member); });
    }
  }
  access_.entities_without_engine.remove(member);
  mover = nullptr;
  return former;
}

void Handover::add(Row member, Engine& engine, Role role) {
  call("add", engine, [&] { engine.add(space_, member, role); });
}

void Handover::commit(std::vector<Event>& events) {
  SWARMANOID_EXPECTS(problem().empty());
  for (const Row mirror : mirrors_) {  // moved members meet mirrors at their present poses
    call("place", target_, [&] { target_.place(space_, mirror); });
  }
  std::vector<Engine*> former;
  former.reserve(members_.size());
  for (const Row member : members_) {
    former.push_back(takeOut(member));
  }
  for (std::size_t k = 0; k < members_.size(); ++k) {
    const Row member = members_[k];
    changeMemberships(memberships_[member], former[k], target_);
    access_.mover[member] = &target_;
    add(member, target_, Role::kMove);
    std::string text = "from " + (former[k] == nullptr ? "no engine" : former[k]->id()) + " to " + target_.id();
    const auto idle = idleDevices(target_, *space_.entities.model[member], devicesOf(groupOf(instances_, member)));
    text += idle.empty() ? "" : "; idle there: " + joinNames(idle);
    events.push_back({Event::Kind::kHandedOver, space_.entities.name[member], "", text});
  }
  // added last, so that no engine mirrors one half of a structure while it moves the other half
  for (std::size_t k = 0; k < members_.size(); ++k) {
    for (const Membership& membership : memberships_[members_[k]]) {
      if (membership.engine == former[k]) {
        add(members_[k], *former[k], Role::kMirror);
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
