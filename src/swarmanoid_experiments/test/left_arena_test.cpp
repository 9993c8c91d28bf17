// The event left_arena: for entities outside the arena, but not for hard landings in its middle.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

/// A prey, with its origin in its foot, falls from 2.4 m. @return ticks of 10 ms until it leaves the arena; -1: not
/// within 2 s
/// @param least returns its minimum height [m]
int ticksUntilLeft(const std::string& ground, double& least) {
  loadPluginLibrary("swarmanoid_engines", {}, {});
  Simulation simulation(parseExperiment(
      "<ahss-config><framework><clocktick>10</clocktick><maxclock>200</maxclock></framework>"
      "<controllers/><arena size='7,9,3' optimization='3D' bounded='false'>"
      "<cylindric_prey id='p'><position>3.1,4.3,2.4</position><orientation>0,0,0</orientation><radius>0.1</radius>"
      "<height>0.12</height><mass>0.7</mass></cylindric_prey></arena>"
      "<engines><dynamics3d id='e'><subclock>1</subclock><ground>" +
          ground +
          "</ground></dynamics3d></engines>"
          "<arena_physics><engine id='e'><entity id='p'/></engine></arena_physics></ahss-config>",
      "fall.xml"));
  simulation.start();
  const Space& space = simulation.space();
  least = 2.4;
  int left = -1;
  while (!simulation.isFinished()) {
    simulation.tick();
    least = std::min(least, space.entities.pose[space.entities.order.front()].position.z());
    for (const Event& event : space.events) {
      left = event.kind == Event::Kind::kLeftArena && left < 0 ? static_cast<int>(space.tick) : left;
    }
  }
  return left;
}

TEST(LeftArenaTest, AHardLandingLeavesNoArena) {
  // at sqrt(2 g 2.4) = 6.9 m/s it moves 69 mm in a step, and penetrates the ground before it is stopped
  double least = 0.0;
  EXPECT_EQ(ticksUntilLeft("true", least), -1);
  EXPECT_LT(least, -1e-3);
}

TEST(LeftArenaTest, AFallThroughIt) {
  // its origin is 0.1 m below the ground's height after sqrt(2 (2.4 + 0.1) / g) = 0.714 s
  double least = 0.0;
  EXPECT_NEAR(ticksUntilLeft("false", least), 72, 1);
}

}  // namespace
}  // namespace swarmanoid::test
