/// How entities change the engine that moves them (thesis chapter 5): decide, then commit.
#pragma once

#include <string>
#include <vector>

#include "membership.hpp"
#include "robot_instance.hpp"

namespace swarmanoid {

/// Puts the engine's mirrors where their entities are now, else it would decide by where they were a tick ago.
void refreshMirrors(Space& space, const ByRow<std::vector<Membership>>& memberships, Engine& engine);

/// Why the engine cannot move such an entity with these devices; "" if it can. A device that it cannot simulate, but
/// that may stand idle, is no reason if another of the engines that hold the entity can simulate it.
/// @param memberships of the entity in engines, as they are or will be
std::string unsupportedReasonOf(const Engine& engine, const EntityModel& model, const std::vector<DeviceUse>& devices,
                                const std::vector<Membership>& memberships);

/// The types of those of a robot's devices that stand idle while the engine moves it.
std::vector<std::string> idleDevices(const Engine& engine, const EntityModel& model,
                                     const std::vector<DeviceUse>& devices);

/// Why the engine cannot take charge of the members of a structure where they stand; "" if it can. Whether the members
/// overlap each other is not looked at: they stood like this, and grip each other, in the engine that they come from.
/// @pre its mirrors are refreshed
/// @param row the member that it is about; what hinders another one is reported with that one's name
std::string handoverProblem(const Space& space, const std::vector<RobotInstance>& instances,
                            const ByRow<std::vector<Membership>>& memberships, const std::vector<Row>& members, Row row,
                            const Engine& engine);

/// Lets the engine take charge of them. @param members parents before children @param events get one for each of them
/// @pre no problem
void commitHandover(Space& space, const std::vector<RobotInstance>& instances,
                    ByRow<std::vector<Membership>>& memberships, const std::vector<Row>& members, Engine& engine,
                    std::vector<Event>& events);

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
