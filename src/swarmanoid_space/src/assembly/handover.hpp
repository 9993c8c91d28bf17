/// Handover of entities to another engine (thesis chapter 5): decide, then commit.
#pragma once

#include <string>
#include <vector>

#include "membership.hpp"
#include "named_plugin.hpp"
#include "robot_instance.hpp"

namespace swarmanoid {

/// Reason why the engine cannot move an entity of the model with these devices; "" if it can. An unsupported device
/// that may stand idle is accepted if another engine that holds the entity can simulate it.
/// @param memberships of the entity in engines, present or planned
std::string unsupportedReasonOf(const Engine& engine, const EntityModel& model, const std::vector<DeviceUse>& devices,
                                const std::vector<Membership>& memberships);

/// Types of the robot's devices that stand idle while the engine moves the robot.
std::vector<std::string> idleDevices(const Engine& engine, const EntityModel& model,
                                     const std::vector<DeviceUse>& devices);

/// Handover of a structure to an engine, between two ticks or at the end of one: first `problem`, then `commit`. A call
/// that does not return is reported with the name of its engine (UserCode).
class Handover {
 public:
  /// @param row member of the structure whose handover is requested
  Handover(const Space& space, const HandOverAccess& access, const std::vector<Named<Engine>>& engines,
           const std::vector<RobotInstance>& instances, ByRow<std::vector<Membership>>& memberships, Row row,
           Engine& target);

  /// Reason why the engine cannot take over all members at their present poses; "" if it can. The function changes
  /// nothing. A problem of a member other than `row` is reported with that member's name. Overlaps of members with each
  /// other are not checked: they have these poses, and grip each other, in the engine that moves them now.
  std::string problem() const;

  /// Hands the members over to the engine. @param events get one event for each member @pre no problem
  void commit(std::vector<Event>& events);

 private:
  std::string problemOf(Row member) const;
  /// First entity by number that a member would overlap in the target; kNoRow if there is none.
  Row overlapOf(const EntityModel& posed, const Pose& pose) const;
  Engine* takeOut(Row member);
  void add(Row member, Engine& engine, Role role);
  template <class Action>
  auto call(const char* phase, const Engine& engine, Action action) const;

  const Space& space_;
  HandOverAccess access_;
  const std::vector<Named<Engine>>& engines_;
  const std::vector<RobotInstance>& instances_;
  ByRow<std::vector<Membership>>& memberships_;
  Row row_;
  Engine& target_;
  std::vector<Row> members_;  // parents before children
  std::vector<Row> mirrors_;  // movable mirrors of the target
};

/// A handover rule for one entity, and its state.
struct HandoverTrigger {
  const HandoverDescription* rule = nullptr;
  Engine* engine = nullptr;
  Row row = kNoRow;
  EntityNumber number = kNoEntity;
  bool was_true = false;    ///< value of the condition at the end of the last tick
  bool is_due = false;      ///< the condition became and still is true, and the handover has not happened yet
  bool is_refused = false;  ///< the due handover was refused, and the refusal was reported
};

/// Evaluates the condition of a rule for an entity.
bool holds(const HandoverDescription& rule, const Space& space, Row row);

}  // namespace swarmanoid
