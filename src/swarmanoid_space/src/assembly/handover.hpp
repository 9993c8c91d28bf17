/// How entities change the engine that moves them (thesis chapter 5): decide, then commit.
#pragma once

#include <string>
#include <vector>

#include "membership.hpp"
#include "named_plugin.hpp"
#include "robot_instance.hpp"

namespace swarmanoid {

/// Why the engine cannot move such an entity with these devices; "" if it can. A device that it cannot simulate, but
/// that may stand idle, is no reason if another of the engines that hold the entity can simulate it.
/// @param memberships of the entity in engines, as they are or will be
std::string unsupportedReasonOf(const Engine& engine, const EntityModel& model, const std::vector<DeviceUse>& devices,
                                const std::vector<Membership>& memberships);

/// The types of those of a robot's devices that stand idle while the engine moves it.
std::vector<std::string> idleDevices(const Engine& engine, const EntityModel& model,
                                     const std::vector<DeviceUse>& devices);

/// The handover of a structure to an engine, between two ticks or at the end of one: first `problem`, then `commit`. A
/// call that does not return is reported with the name of its engine (UserCode).
class Handover {
 public:
  /// @param row the member of the structure that it is about
  Handover(Space& space, const std::vector<Named<Engine>>& engines, const std::vector<RobotInstance>& instances,
           ByRow<std::vector<Membership>>& memberships, Row row, Engine& target);

  /// Why the engine cannot take charge of all members where they stand; "" if it can. Asking changes nothing. What
  /// hinders another member than the one that it is about has that one's name. Whether the members overlap each other
  /// is not looked at: they stood like this, and grip each other, in the engine that they come from.
  std::string problem() const;

  /// Lets the engine take charge of them. @param events get one for each of them @pre no problem
  void commit(std::vector<Event>& events);

 private:
  std::string problemOf(Row member) const;
  /// What a member would overlap in the target, by entity number; kNoRow if there is nothing.
  Row overlapOf(const EntityModel& posed, const Pose& pose) const;
  Engine* takeOut(Row member);
  void add(Row member, Engine& engine, Role role);
  template <class Action>
  auto call(const char* phase, const Engine& engine, Action action) const;

  Space& space_;
  const std::vector<Named<Engine>>& engines_;
  const std::vector<RobotInstance>& instances_;
  ByRow<std::vector<Membership>>& memberships_;
  Row row_;
  Engine& target_;
  std::vector<Row> members_;  // parents before children
  std::vector<Row> mirrors_;  // of the target, that can move
};

/// A rule for one entity, and how far it has come.
struct HandoverTrigger {
  const HandoverDescription* rule = nullptr;
  Engine* engine = nullptr;
  Row row = kNoRow;
  EntityNumber number = kNoEntity;
  bool was_true = false;    ///< the condition, at the end of the last tick
  bool is_due = false;      ///< it became true, is still true, and nothing has come of it yet
  bool is_refused = false;  ///< since then; that has been reported
};

/// Whether the condition of a rule is true for an entity now.
bool holds(const HandoverDescription& rule, const Space& space, Row row);

}  // namespace swarmanoid
