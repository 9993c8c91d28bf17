/// All that a simulation is assembled of beside its space: threads, engines, robots, rules, observers, and
/// which engines hold which entities.
///
/// Threads  as Simulation.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "handover.hpp"
#include "membership.hpp"
#include "named_plugin.hpp"
#include "robot_instance.hpp"
#include "swarmanoid_space/space.hpp"
#include "workers.hpp"

namespace swarmanoid {

struct Assembly {
  Assembly(int threads, Columns& columns) : workers(threads), memberships(columns, {"memberships", Writer::kConnect}) {}

  Workers workers;
  std::vector<Named<Engine>> engines;
  std::vector<std::unique_ptr<ControllerGroup>> groups;
  std::vector<RobotInstance> robots;  ///< by entity number
  Column<std::vector<Membership>> memberships;
  std::vector<HandoverTrigger> triggers;  ///< by entity number, then as in the file
  std::vector<RuleInstance> rules;        ///< as in the file
  std::vector<ObserverInstance> observers;

  Engine* findEngine(const std::string& id) const;
  ControllerGroup* findGroup(const std::string& id) const;
  /// @return null for an entity without a controller, and for kNoRow
  RobotInstance* findRobot(const Entities& entities, Row row);
};

}  // namespace swarmanoid
