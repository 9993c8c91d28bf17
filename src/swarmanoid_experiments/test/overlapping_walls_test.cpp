// Overlapping walls, as in the corners of most arenas: allowed for static bodies, in each engine.
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "test_world.hpp"

namespace swarmanoid {
namespace {

std::string wall(const std::string& id, double x, double y, double heading, double length,
                 const std::string& more = "") {
  return "<block id='" + id + "'><position>" + std::to_string(x) + "," + std::to_string(y) + ",0.2</position>" +
         "<orientation>0,0," + std::to_string(heading) + "</orientation><size>" + std::to_string(length) +
         ",0.1,0.4</size>" + more + "</block>";
}

class OverlappingWallsTest : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override { loadBuiltInPlugins(); }

  static std::string experiment(const std::string& walls, const std::string& names, double robot_x = 2.0) {
    return std::string("<ahss-config><framework><clocktick>100</clocktick><maxclock>30</maxclock></framework>") +
           "<arena size='4,4,2' optimization='2D' bounded='true'>" + walls + "<footbot id='robot'><position>" +
           std::to_string(robot_x) + ",2,0</position></footbot></arena>" + "<engines><" + GetParam() +
           " id='ground'/></engines><arena_physics><engine id='ground'><entity id='robot'/>" + names +
           "</engine></arena_physics></ahss-config>";
  }
  static std::string refusal(const std::string& text) {
    try {
      Simulation simulation(parseExperiment(text, "walls.xml"));
      simulation.start();
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  }
};

TEST_P(OverlappingWallsTest, RandomWallsStandInEachOther) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> some(0.0, 1.0);
  std::string walls;
  std::string names;
  for (int i = 0; i < 60; ++i) {
    const double side = 0.2 + 0.9 * some(random);
    walls += wall("w" + std::to_string(i), 4.0 * some(random), some(random) < 0.5 ? side : 4.0 - side,
                  180.0 * some(random), 0.2 + some(random));
    names += "<entity id='w" + std::to_string(i) + "'/>";
  }
  Simulation simulation(parseExperiment(experiment(walls, names), "walls.xml"));
  simulation.start();
  while (!simulation.isFinished()) {
    simulation.tick();
  }
  const Space& space = simulation.space();
  EXPECT_NEAR(space.entities.pose[space.entities.find("robot")].position.x(), 2.0, 0.02) << "nothing has thrown it";
}

TEST_P(OverlappingWallsTest, RobotsAndWhatMovesMayNot) {
  const std::string names = "<entity id='w'/><entity id='v'/>";
  const std::string crossed = wall("w", 2.0, 1.0, 0.0, 1.0) + wall("v", 2.0, 1.1, 37.0, 1.0);
  EXPECT_EQ(refusal(experiment(crossed, names)), "");
  EXPECT_NE(refusal(experiment(wall("w", 2.0, 2.0, 20.0, 1.0) + wall("v", 2.0, 1.0, 0.0, 1.0), names)).find("overlaps"),
            std::string::npos);
  const std::string pushed = wall("v", 2.0, 1.1, 37.0, 1.0, "<mass>1</mass>");
  const bool has_masses = std::string(GetParam()) != "kinematics2d";
  if (has_masses) {
    EXPECT_NE(refusal(experiment(wall("w", 2.0, 1.0, 0.0, 1.0) + pushed, names)).find("overlaps"), std::string::npos);
  }
}

INSTANTIATE_TEST_SUITE_P(Engines, OverlappingWallsTest, testing::Values("kinematics2d", "dynamics2d", "dynamics3d"));

}  // namespace
}  // namespace swarmanoid
