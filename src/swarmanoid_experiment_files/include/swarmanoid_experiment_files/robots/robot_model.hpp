/// Models of robots, read from their URDF files.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "swarmanoid_space/models/entity_model.hpp"

namespace swarmanoid {

/// Reads a robot's URDF. The root link is `base_link`, the body frame. Collision elements of links (boxes, cylinders,
/// spheres) become shapes, all links become mounts, both placed with all joints at zero. Revolute and continuous joints
/// become joints. The element <swarmanoid> below <robot> states which joints are wheels (continuous, axis y, with a
/// velocity limit; the widest cylinder of their child link is the wheel), which links are holders, LEDs (`led_0`,
/// `led_1`, ..., at most EntityModel::kMaxLeds) or a gripping strip (it is not a shape), and which devices of others it
/// carries.
/// @throws ConfigError naming the file and the mistake, also for mistakes that urdfdom only prints
std::shared_ptr<const EntityModel> loadRobotModel(const std::string& type, const std::string& urdf_file);

/// Same as loadRobotModel, but collects all mistakes instead of throwing the first.
/// @param problems receives a message for each mistake @return null if there is any
std::shared_ptr<const EntityModel> checkRobotFile(const std::string& type, const std::string& urdf_file,
                                                  std::vector<std::string>& problems);

/// The model of an installed robot type, from <type>.urdf in a folder that a package exports in its package.xml, as
/// <export><swarmanoid robots="${prefix}/urdf"/></export>. Loaded once per process. Thread-safe.
/// @throws ConfigError if there is no such robot, or if there are two
std::shared_ptr<const EntityModel> robotModel(const std::string& type);

/// The model of the same robot with that battery and its properties (BatteryProperty).
std::shared_ptr<const EntityModel> robotWithBattery(const EntityModel& robot, const BatteryModel& battery);

/// Loads all installed robots. Thread-safe.
/// @return mistakes in them and in the packages that provide them, one message each
std::vector<std::string> robotProblems();

}  // namespace swarmanoid
