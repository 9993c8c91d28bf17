// Each formula of docs/reference/models.md has a test of its name in this program, each test has a formula there, and
// the constants are those of robots and engines.
#include <gtest/gtest.h>

#include <cctype>
#include <fstream>
#include <set>
#include <string>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_space/experiment/experiment.hpp"
#include "swarmanoid_space/models/entity_model.hpp"

namespace swarmanoid::test {
namespace {

/// Converts "Blob bearing and distance" to BlobBearingAndDistance.
std::string nameOf(const std::string& heading) {
  std::string name;
  bool is_start = true;
  for (const char c : heading) {
    if (c != ' ') {
      name += is_start ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    }
    is_start = c == ' ';
  }
  return name;
}

TEST(ModelsPageHeadings, AreTheNamesOfTheTests) {
  std::set<std::string> headings;
  std::ifstream page(PAGE);
  ASSERT_TRUE(page) << PAGE;
  for (std::string line; std::getline(page, line);) {
    if (line.rfind("### ", 0) == 0) {
      EXPECT_TRUE(headings.insert(nameOf(line.substr(4))).second) << line << ": twice";
    }
  }
  std::set<std::string> tests;
  const testing::UnitTest& program = *testing::UnitTest::GetInstance();
  for (int i = 0; i < program.total_test_suite_count(); ++i) {
    const testing::TestSuite& suite = *program.GetTestSuite(i);
    for (int k = 0; k < suite.total_test_count() && std::string(suite.name()) == "ModelsPageTest"; ++k) {
      tests.insert(suite.GetTestInfo(k)->name());
    }
  }
  EXPECT_GE(tests.size(), 15U);
  EXPECT_EQ(headings, tests);
}

double defaultOf(PluginKind kind, const std::string& label, const std::string& name) {
  for (const Parameter& parameter : Registry::instance().find(kind, label)->description.parameters) {
    if (parameter.name == name) {
      return std::stod(*parameter.value);
    }
  }
  ADD_FAILURE() << label << " has no parameter " << name;
  return 0.0;
}

TEST(ModelsPageConstants, AreThoseOfTheRobots) {
  const EntityModel& footbot = *robotModel("footbot");
  EXPECT_EQ(footbot.wheels->radius, 0.029);
  EXPECT_NEAR(footbot.wheels->separation, 0.14, 1e-9);
  EXPECT_NEAR(footbot.wheels->max_speed, 10.34, 0.005);
  EXPECT_NEAR(footbot.mass, 1.8, 1e-9);
  EXPECT_NEAR(footbot.centre_of_mass.z(), 0.0654, 5e-5);
  EXPECT_NEAR(footbot.highest, 0.146, 1e-12);
  EXPECT_EQ(footbot.gripper->tip, 0.11);
  EXPECT_EQ(footbot.gripper->height, 0.05);
  EXPECT_EQ(*footbot.gripping_radius, 0.085);
  EXPECT_EQ(*robotModel("handbot")->gripping_radius, 0.145);
  EXPECT_EQ(footbot.mount("camera").position.z(), 0.28);
  EXPECT_NEAR(footbot.led_positions.at(7).head<2>().norm(), 0.085, 1e-9);
  EXPECT_EQ(footbot.led_positions.at(7).z(), 0.12);
  const EntityModel::Joint& turret = footbot.joints.at(static_cast<std::size_t>(footbot.findJoint("turret")));
  EXPECT_EQ(turret.max_speed, 3.0);
  EXPECT_EQ(turret.max_effort, 2.0);
  EXPECT_NEAR(robotModel("eyebot")->mass, 2.0, 1e-9);
  EXPECT_NEAR(robotModel("eyebot")->centre_of_mass.z(), 0.28, 1e-9);
  EXPECT_EQ(robotModel("eyebot")->mount("camera").position.z(), 0.15);
  EXPECT_EQ(kPreyMass, 0.3);
}

TEST(ModelsPageConstants, AreTheDefaultsOfTheEngines) {
  loadBuiltInPlugins();
  for (const char* engine : {"dynamics2d", "dynamics3d"}) {
    EXPECT_EQ(defaultOf(PluginKind::kEngine, engine, "gravity"), 9.81);
    EXPECT_EQ(defaultOf(PluginKind::kEngine, engine, "treel_friction"), 0.9);
  }
  EXPECT_EQ(defaultOf(PluginKind::kEngine, "dynamics2d", "ground_friction"), 0.4);
  EXPECT_EQ(defaultOf(PluginKind::kEngine, "dynamics2d", "contact_friction"), 0.3);
  EXPECT_EQ(defaultOf(PluginKind::kEngine, "dynamics3d", "friction"), 0.5);
}

}  // namespace
}  // namespace swarmanoid::test
