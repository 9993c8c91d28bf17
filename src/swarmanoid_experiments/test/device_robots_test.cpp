// Headers and simulations agree on the kind of each device of the suite, and on its robot.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_space/experiment/experiment.hpp"

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

TEST(DeviceRobotsTest, TheRegistryKnowsTheRobotThatTheStructNames) {
  for (const Registry::Entry* entry : devices()) {
    const std::string& robot = findDeviceType(entry->description.label)->robot;
    EXPECT_EQ(entry->description.robots, robot.empty() ? Texts{} : Texts{robot}) << entry->description.label;
  }
}

}  // namespace
}  // namespace swarmanoid
