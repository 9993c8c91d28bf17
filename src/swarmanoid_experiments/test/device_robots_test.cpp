// Headers, simulations and descriptions of robots agree on what each device of the suite is, and on which robot.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_space/experiment_file/experiment.hpp"
#include "swarmanoid_space/models/entity_model.hpp"

namespace swarmanoid {
namespace {

using Texts = std::vector<std::string>;

std::vector<const Registry::Entry*> devices() {
  loadBuiltInPlugins();
  std::vector<const Registry::Entry*> entries = Registry::instance().all(PluginKind::kSensor);
  const auto actuators = Registry::instance().all(PluginKind::kActuator);
  entries.insert(entries.end(), actuators.begin(), actuators.end());
  return entries;
}

TEST(DeviceRobotsTest, EverySimulationIsOfADeviceOfItsKind) {
  ASSERT_GE(devices().size(), 20U);
  for (const Registry::Entry* entry : devices()) {
    const DeviceType* type = findDeviceType(entry->description.label);
    ASSERT_NE(type, nullptr) << entry->description.label;
    EXPECT_EQ(toString(entry->kind), std::string(toString(type->kind))) << type->type;
  }
}

TEST(DeviceRobotsTest, ADeviceOfOneRobotIsInItsDescription) {
  for (const Registry::Entry* entry : devices()) {
    const std::string& device = entry->description.label;
    const std::string& robot = findDeviceType(device)->robot;
    EXPECT_EQ(entry->description.robots, robot.empty() ? Texts{} : Texts{robot}) << device;
    if (!robot.empty()) {
      const Texts& listed = robotModel(robot)->devices;
      EXPECT_EQ(std::count(listed.begin(), listed.end(), device), 1) << device << " in the URDF of the " << robot;
    }
  }
}

}  // namespace
}  // namespace swarmanoid
