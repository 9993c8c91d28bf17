/// Who acts in a simulation: engines, devices, controllers, visualisations.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/process/user_code.hpp"
#include "swarmanoid_space/actuator.hpp"
#include "swarmanoid_space/engine.hpp"
#include "swarmanoid_space/lockstep/lockstep.hpp"
#include "swarmanoid_space/observer.hpp"
#include "swarmanoid_space/sensor.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"
#include "workers.hpp"

namespace swarmanoid {

/// A plugin, and its description for messages (UserCode::part): "engine 'ground' (dynamics2d)".
template <class Plugin>
struct Named {
  std::shared_ptr<Plugin> plugin;
  std::string part;

  Plugin* get() const { return plugin.get(); }
  Plugin* operator->() const { return plugin.get(); }
  Plugin& operator*() const { return *plugin; }
};

/// An observer of the run, and how far it has come.
struct ObserverInstance : Named<Observer> {
  bool is_finished = false;  ///< or about to be
  bool is_given_up = false;  ///< a call of it does not return
};

/// One controller configuration of the experiment, with the devices that all its robots share.
struct ControllerGroup {
  const ControllerDescription* description = nullptr;
  std::vector<Named<Sensor>> sensors;
  std::vector<Named<Actuator>> actuators;
  std::function<std::shared_ptr<Controller>()> make;
  std::string part;  ///< what `make` makes, as UserCode has it
};

/// Types of its devices; none without a group.
std::vector<std::string> devicesOf(const ControllerGroup* group);

/// One robot of the simulation, with its controller and its failure.
struct RobotInstance {
  Row row = kNoRow;
  Robot* robot = nullptr;
  ControllerGroup* group = nullptr;
  CommandSource source = CommandSource::kController;
  std::shared_ptr<Controller> controller;  ///< null unless the source is kController
  UserCode step;                           ///< of the controller
  Duration command_timeout{};              ///< with kTopics, these three
  Time last_command = kEpoch;
  bool is_commanded = false;        ///< a command has come, and not too long ago
  std::optional<Time> stops_since;  ///< no controller commands it any more, and its safe stop is not over
  bool has_failed = false;
  std::string failure;  ///< set by `control` or `actuate` in the tick in which it fails
};

/// The membership of an entity in one engine, and its role there.
struct Membership {
  Engine* engine = nullptr;
  Role role = Role::kMove;
  bool is_listed = true;  ///< by the experiment file or the spawn request; else it is there for as long as it is moved
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

struct Simulation::Cast {
  explicit Cast(int threads) : workers(threads) {}

  Workers workers;
  std::vector<Named<Engine>> engines;
  std::vector<std::unique_ptr<ControllerGroup>> groups;
  std::vector<RobotInstance> robots;                 ///< by entity number
  std::vector<std::vector<Membership>> memberships;  ///< by entity row
  std::vector<HandoverTrigger> triggers;             ///< by entity number, then as in the file
  std::vector<ObserverInstance> observers;
  std::vector<Row> faulty;  ///< scratch of `actuate`
  Lockstep lockstep;

  Engine* findEngine(const std::string& id) const;
  /// As UserCode has it. @pre it is one of the engines
  const std::string& partOf(const Engine& engine) const;
  ControllerGroup* findGroup(const std::string& id) const;
  /// @return null for an entity without a controller, and for kNoRow
  RobotInstance* findRobot(const Entities& entities, Row row);
};

}  // namespace swarmanoid
