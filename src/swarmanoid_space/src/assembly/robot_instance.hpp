/// The robots of a simulation, with their controllers, and the controller configurations that they share.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "named_plugin.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/process/user_code.hpp"
#include "swarmanoid_space/actuator.hpp"
#include "swarmanoid_space/group_controller.hpp"
#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid {

struct RobotInstance;

/// One controller configuration of the experiment, with the devices that all its robots share.
struct ControllerGroup {
  const ControllerDescription* description = nullptr;
  std::vector<Named<Sensor>> sensors;
  std::vector<Named<Actuator>> actuators;
  std::vector<DeviceUse> devices;  ///< all of them
  /// Steps the robots together; null: each has a controller of its own, which `make` makes.
  std::shared_ptr<GroupController> together;
  std::vector<GroupMember> members;     ///< scratch of `control`
  std::vector<RobotInstance*> stepped;  ///< likewise: whose members these are
  std::function<std::shared_ptr<Controller>()> make;
  std::string part;  ///< `together`, or what `make` makes, as UserCode has it
};

/// Its devices; none without a group.
const std::vector<DeviceUse>& devicesOf(const ControllerGroup* group);

/// One robot of the simulation, with its controller and its failure. What `control` reads of each in each tick stands
/// in the first two cache lines.
struct alignas(64) RobotInstance {
  Row row = kNoRow;
  CommandSource source = CommandSource::kController;
  bool has_failed = false;
  bool is_commanded = false;  ///< with kTopics: a command has come, and not too long ago
  Robot* robot = nullptr;
  std::shared_ptr<Controller> controller;  ///< null unless the source is kController, and for groups stepped together
  std::optional<Time> stops_since;         ///< no controller commands it any more, and its safe stop is not over
  UserCode step;                           ///< of the controller
  ControllerGroup* group = nullptr;
  std::optional<CommandSource> source_when_charged;  ///< its battery is empty; then the source is kNone
  Duration command_timeout{};                        ///< with kTopics, these two
  Time last_command = kEpoch;
  std::string failure;  ///< set by `control` or `actuate` in the tick in which it fails
};

/// A controller of the robot's own, started. @return null if its group is stepped together
/// @throws what startController throws
std::shared_ptr<Controller> startControllerOf(const RobotInstance& instance, Space& space);

}  // namespace swarmanoid
