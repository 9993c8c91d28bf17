/// Robots of a simulation, their controllers, and the controller configurations that they share.
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
  std::vector<DeviceUse> devices;  ///< of all sensors and actuators
  /// Steps all robots of the group in one call; null if each robot has a controller of its own, created by `make`.
  std::shared_ptr<GroupController> together;
  std::vector<GroupMember> members;     ///< scratch of `control`
  std::vector<RobotInstance*> stepped;  ///< scratch of `control`: the robots of `members`, in their order
  std::function<std::shared_ptr<Controller>()> make;
  std::string part;  ///< describes `together`, or the controllers that `make` creates (UserCode::part)
};

/// Devices of the group; empty if `group` is null.
const std::vector<DeviceUse>& devicesOf(const ControllerGroup* group);

/// One robot of the simulation, with its controller and its failure. The fields that `control` reads in every tick are
/// in the first two cache lines.
struct alignas(64) RobotInstance {
  Row row = kNoRow;
  CommandSource source = CommandSource::kController;
  bool has_failed = false;
  bool is_commanded = false;  ///< with kTopics: a command arrived within the timeout
  Robot* robot = nullptr;
  std::shared_ptr<Controller> controller;  ///< null unless the source is kController, and for groups stepped together
  std::optional<Time> stops_since;  ///< start of a safe stop in progress; the robot's controller no longer commands it
  UserCode step;                    ///< description of the controller's step for UserCode
  ControllerGroup* group = nullptr;
  /// Source to restore; set while the battery is empty, when `source` is kNone.
  std::optional<CommandSource> source_when_charged;
  Duration command_timeout{};  ///< with kTopics, this and the next
  Time last_command = kEpoch;
  std::string failure;  ///< reason, set by `control` or `actuate` in the tick of the failure
};

/// Creates and starts a controller for one robot. @return null if its group is stepped together
/// @throws the exceptions of startController
std::shared_ptr<Controller> startControllerOf(const RobotInstance& instance, Space& space);

}  // namespace swarmanoid
