/// Everything that a simulation consists of besides its space: threads, engines, robots, rules, observers, and the
/// membership of entities in engines.
///
/// Threads  see Simulation.
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
  Assembly(int threads, Columns& columns) : workers(threads), memberships(columns, {"memberships"}) {}

  Workers workers;
  std::vector<Named<Engine>> engines;
  std::vector<std::unique_ptr<ControllerGroup>> groups;
  std::vector<RobotInstance> robots;  ///< by entity number
  Column<std::vector<Membership>, WrittenIn::kConnect> memberships;
  std::vector<HandoverTrigger> triggers;  ///< sorted by entity number, then in the order of the file
  std::vector<RuleInstance> rules;        ///< in the order of the file
  std::vector<ObserverInstance> observers;

  Engine* findEngine(const std::string& id) const;
  ControllerGroup* findGroup(const std::string& id) const;
  /// @return null for an entity without a controller, and for kNoRow
  RobotInstance* findRobot(const Entities& entities, Row row);
};

}  // namespace swarmanoid
