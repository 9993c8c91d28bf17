// Reading each section of an experiment file, with defaults.
#include "swarmanoid_space/experiment/experiment.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>

#include "experiment_fixture.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/process/temporary_folder.hpp"

namespace swarmanoid::test {
namespace {

TEST_F(ExperimentTest, ReadsFrameworkWithDefaults) {
  const Experiment experiment = parse();
  EXPECT_EQ(experiment.name, "some");
  EXPECT_EQ(experiment.file, "folder/some.xml");
  EXPECT_EQ(experiment.text, kFile);
  EXPECT_EQ(experiment.framework.clocktick, std::chrono::microseconds(12500));
  EXPECT_EQ(experiment.framework.max_clock, 500U);
  EXPECT_EQ(experiment.framework.seed, 1U);
  EXPECT_EQ(experiment.framework.threads, 1);
  EXPECT_EQ(experiment.framework.real_time_factor, 0.0);
  EXPECT_TRUE(experiment.framework.controller_path.empty());
}

TEST_F(ExperimentTest, ReadsControllersWithTheirDevices) {
  const Experiment experiment = parse();
  ASSERT_EQ(experiment.controllers.size(), 1U);
  const ControllerDescription& controller = experiment.controllers[0];
  EXPECT_EQ(controller.label, "wander");
  EXPECT_EQ(controller.id, "slow");
  EXPECT_EQ(controller.library, "") << "the label is known, so no library is looked for";
  EXPECT_EQ(controller.location.line, 7);
  ASSERT_EQ(controller.actuators.size(), 1U);
  EXPECT_EQ(controller.actuators[0].implementation, "default");
  EXPECT_EQ(controller.actuators[0].parameters.number("noise"), 0.0);
  ASSERT_EQ(controller.sensors.size(), 1U);
  EXPECT_EQ(controller.sensors[0].implementation, "blobs");
  EXPECT_EQ(controller.sensors[0].parameters.number("range"), 2.0);
  EXPECT_EQ(controller.parameters.number("speed"), 0.5);
  EXPECT_TRUE(controller.parameters.boolean("shy")) << "an attribute is as good as an element";
}

TEST_F(ExperimentTest, EachImplementationHasItsOwnParameters) {
  std::string text = kFile;
  text.replace(text.find(" old_eye "), 9, "pixels");
  EXPECT_EQ(refusal({}, text),
            "some.xml:10: found tag 'range', allowed: width, implementation, realism, error (in <eye>)");
}

TEST_F(ExperimentTest, TheTagErrorIsNoParameter) {
  std::string text = kFile;
  const std::string eye = "<eye><implementation> old_eye </implementation><range>2</range></eye>";
  text.replace(text.find(eye), eye.size(), "<sonar/>");
  EXPECT_EQ(refusal({}, text),
            "some.xml:10: found the parameter 'error' of the implementation 'default', allowed: another name, since "
            "<error> in a device is an error model");
  text.replace(text.find("<sonar/>"), 8, "<eye><implementation>blobs</implementation><error kind='dead'/></eye>");
  EXPECT_EQ(refusal({}, text), "some.xml:10: found an error of 'eye', allowed: of a device with REGISTER_DEVICE");
}

TEST_F(ExperimentTest, AnImplementationIsNamedWhereNoneIsTheDefault) {
  std::string text = kFile;
  const std::string named = "<eye><implementation> old_eye </implementation><range>2</range></eye>";
  text.replace(text.find(named), named.size(), "<eye/>");
  EXPECT_EQ(refusal({}, text),
            "some.xml:10: found no <implementation> of sensor 'eye', which has no default, allowed: blobs, pixels");
}

TEST_F(ExperimentTest, ReadsArenaInRadians) {
  const ArenaDescription arena = parse().arena;
  EXPECT_EQ(arena.size, Eigen::Vector3d(10, 9, 3));
  EXPECT_EQ(arena.optimization, PositionalIndex::Optimization::k3D);
  EXPECT_FALSE(arena.bounded);
  ASSERT_EQ(arena.entities.size(), 2U);
  EXPECT_EQ(arena.entities[0].position, Eigen::Vector3d(9, 8, 0));
  EXPECT_DOUBLE_EQ(arena.entities[0].angles.z(), M_PI / 2);
  EXPECT_EQ(arena.entities[0].controller, "slow");
  EXPECT_FALSE(arena.entities[0].distribution.has_value());
  EXPECT_EQ(arena.entities[1].color, colors::kWhite);
  ASSERT_TRUE(arena.entities[1].distribution.has_value());
  EXPECT_EQ(arena.entities[1].distribution->quantity, 3U);
  EXPECT_EQ(arena.entities[1].distribution->layout, Distribution::Layout::kUniform);
  EXPECT_TRUE(arena.entities[1].distribution->random_heading);
  ASSERT_EQ(arena.floor.patches.size(), 1U);
  EXPECT_EQ(arena.floor.patches[0].color, (Color{1, 2, 3}));
}

TEST_F(ExperimentTest, ReadsHoles) {
  std::string text = kFile;
  text.insert(text.find("<distribute"),
              "<hole id=\"pit\"><position>3, 2, 0</position><radius>0.25</radius></hole>"
              "<hole id=\"ditch\"><position>5, 2, 0</position><size>0.5, 2</size></hole>");
  const std::vector<FloorHole> holes =
      parseExperiment(text, "some.xml", {{"arena.ditch.size", "0.5, 3"}}).arena.floor.holes;
  ASSERT_EQ(holes.size(), 2U);
  EXPECT_EQ(holes[0].id, "pit");
  EXPECT_EQ(holes[0].position, Eigen::Vector3d(3, 2, 0));
  EXPECT_EQ(holes[0].radius, 0.25);
  EXPECT_EQ(holes[1].size, Eigen::Vector2d(0.5, 3));
}

TEST_F(ExperimentTest, ReadsTheColourOfTheBareFloor) {
  EXPECT_EQ(parse().arena.floor.bare, colors::kWhite) << "unless the file says otherwise";
  std::string text = kFile;
  text.insert(text.find(" optimization=\"3D\""), " floor=\"10, 20,30\"");
  EXPECT_EQ(parseExperiment(text, "some.xml").arena.floor.bare, (Color{10, 20, 30}));
  EXPECT_EQ(parse({{"arena.floor", "orange"}}).arena.floor.bare, colors::kOrange);
  text.replace(text.find("10, 20,30"), 9, "10,20");
  EXPECT_EQ(refusal({}, text),
            "some.xml:15: floor: found '10,20', allowed: black, white, red, green, blue, yellow, magenta, "
            "cyan, orange, gray, or three numbers from 0 to 255");
}

TEST_F(ExperimentTest, ReadsEnginesAndTheirEntities) {
  const Experiment experiment = parse();
  ASSERT_EQ(experiment.engines.size(), 2U);
  EXPECT_EQ(experiment.engines[0].label, "plane");
  EXPECT_EQ(experiment.engines[0].parameters.number("height"), 0.0);
  EXPECT_EQ(experiment.engines[1].parameters.number("height"), 1.0);
  ASSERT_EQ(experiment.mappings.size(), 2U);
  ASSERT_EQ(experiment.mappings[0].members.size(), 2U);
  EXPECT_EQ(experiment.mappings[0].members[0].entity, "prey");
  EXPECT_FALSE(experiment.mappings[0].members[0].role.has_value());
  EXPECT_EQ(experiment.mappings[0].members[1].role, Role::kMirror);
  EXPECT_EQ(experiment.mappings[1].members[0].role, Role::kMove);
  ASSERT_EQ(experiment.visualisations.size(), 1U);
  EXPECT_EQ(experiment.visualisations[0].parameters.text("file"), "");
}

TEST_F(ExperimentTest, JoinsFoldersBrokenOverLinesAndWarnsOfThoseThatAreNotThere) {
  std::string text = kFile;
  const std::string folder = std::filesystem::temp_directory_path();
  text.insert(text.find("  </framework>"),
              "<controller_path>\n  /no/such/\\\n  folder:" + folder + "\n</controller_path>\n");
  takeExperimentWarnings();
  const Experiment experiment = parseExperiment(text, "some.xml");
  EXPECT_EQ(experiment.framework.controller_path, (std::vector<std::string>{"/no/such/folder", folder}));
  EXPECT_EQ(takeExperimentWarnings(),
            std::vector<std::string>{"some.xml:5: controller_path: '/no/such/folder' is not a folder"});
  EXPECT_TRUE(takeExperimentWarnings().empty());
}

TEST_F(ExperimentTest, ReadsFiles) {
  const TemporaryFolder folder("experiment_test");
  const std::filesystem::path file = folder.path() / "some.xml";
  std::ofstream(file) << "\xEF\xBB\xBF" << kFile;
  EXPECT_EQ(readExperiment(file.string()).name, "some");
  EXPECT_THROW(readExperiment("/no/such/file.xml"), ConfigError);
  EXPECT_THROW(readExperiment(folder.path().string()), ConfigError);
}

}  // namespace
}  // namespace swarmanoid::test
