// The rule `path_formation`, without engines: the robots of a path from nest to prey, and the time of the first path.
// With robots that form it: swarmanoid_experiments/test/chain_formation_test.cpp.
#include <gtest/gtest.h>

#include <string>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid::test {
namespace {

std::string pathFootbot(const std::string& id, const std::string& position) {
  return "<footbot id=\"" + id + "\"><position>" + position +
         ", 0</position><orientation>0, 0, 0</orientation></footbot>";
}

/// From the nest at (1, 1) to the prey at (3.9, 1) in steps of at most 0.8 m: a, b, c, or by the detour a, d, e, f, c.
Experiment experiment(const std::string& parameters) {
  loadPluginLibrary("swarmanoid_devices", {}, {});
  return parseExperiment(R"(<ahss-config>
  <framework><clocktick>100</clocktick><maxclock>1000</maxclock></framework>
  <arena size="5,5,3" optimization="2D">
    <light id="nest"><position>1, 1, 2</position><orientation>0, 0, 0</orientation></light>
    <light id="prey"><position>3.9, 1, 0.5</position><orientation>0, 0, 0</orientation></light>)" +
                             pathFootbot("a", "1.7, 1") + pathFootbot("b", "2.45, 1") + pathFootbot("c", "3.2, 1") +
                             pathFootbot("d", "1.9, 1.7") + pathFootbot("e", "2.55, 1.9") +
                             pathFootbot("f", "3.2, 1.7") +
                             "</arena><rules><path_formation id=\"p\"><reach>0.8</reach>" + parameters +
                             "</path_formation></rules></ahss-config>",
                         "path.xml");
}

class PathFormationTest : public testing::Test {
 protected:
  explicit PathFormationTest(const std::string& parameters = "<ends>false</ends>")
      : simulation(experiment(parameters)) {
    simulation.start();
  }

  double metric(const std::string& name) const { return std::get<double>(simulation.metrics().at("p." + name)); }

  /// No controller commands LEDs here: the test sets their colours in the space, as an actuator would.
  void show(const std::string& robots, Color color) {
    Space& space = const_cast<Space&>(simulation.space());
    for (const char robot : robots) {
      space.leds[space.entities.find(std::string(1, robot))][7] = color;
    }
  }

  double lengthAfterTick() {
    simulation.tick();
    return metric("length");
  }

  Simulation simulation;
};

TEST_F(PathFormationTest, ItsRobotsShineAndAreInReachOfEachOther) {
  EXPECT_EQ(lengthAfterTick(), 0.0) << "all stand there, and nobody shines";
  show("abc", colors::kGreen);
  EXPECT_EQ(lengthAfterTick(), 3.0);
  EXPECT_EQ(metric("links"), 3.0);
  show("b", colors::kBlack);
  EXPECT_EQ(lengthAfterTick(), 0.0) << "from a to c it is 1.5 m";
  EXPECT_EQ(metric("links"), 2.0);
  show("def", colors::kYellow);
  EXPECT_EQ(lengthAfterTick(), 5.0) << "by the detour";
  show("b", colors::kBlue);
  EXPECT_EQ(lengthAfterTick(), 3.0) << "the path with fewest robots counts";
  EXPECT_EQ(metric("links"), 6.0);
  show("c", colors::kBlack);
  EXPECT_EQ(lengthAfterTick(), 0.0) << "from f to the prey it is 0.99 m";
}

/// From robot a to robot b, which are within reach of each other; there are links along the detour d, e, f, c.
class PathOfRobotsTest : public PathFormationTest {
 protected:
  PathOfRobotsTest() : PathFormationTest("<nest>a</nest><prey>b</prey><ends>false</ends>") {}
};

TEST_F(PathOfRobotsTest, ItsEndsAreNoLinks) {
  show("ab", colors::kGreen);
  EXPECT_EQ(lengthAfterTick(), 0.0) << "nobody else shines";
  EXPECT_EQ(metric("links"), 0.0);
  show("cdef", colors::kGreen);
  EXPECT_EQ(lengthAfterTick(), 4.0);
  EXPECT_EQ(metric("links"), 4.0);
}

TEST_F(PathFormationTest, TheTimeIsThatOfTheFirstPath) {
  simulation.tick();
  simulation.tick();
  EXPECT_NEAR(metric("formation_time"), 0.2, 1e-12) << "so far";
  show("abc", colors::kRed);
  simulation.tick();
  EXPECT_NEAR(metric("formation_time"), 0.3, 1e-12);
  show("b", colors::kBlack);
  simulation.tick();
  show("b", colors::kRed);
  simulation.tick();
  EXPECT_NEAR(metric("formation_time"), 0.3, 1e-12) << "also after it broke, and was there again";
  EXPECT_FALSE(simulation.isFinished());
}

TEST_F(PathFormationTest, ATickAllocatesNothing) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  show("acdef", colors::kRed);
  simulation.tick();
  simulation.tick();
  const long before = heap_allocations;
  simulation.tick();
  EXPECT_EQ(heap_allocations - before, 0);
}

class EndingPathFormationTest : public PathFormationTest {
 protected:
  EndingPathFormationTest() : PathFormationTest("") {}
};

TEST_F(EndingPathFormationTest, EndsTheRunASuccess) {
  simulation.tick();
  EXPECT_FALSE(simulation.isFinished());
  EXPECT_EQ(simulation.success(), std::optional<bool>(false));
  show("abc", colors::kRed);
  simulation.tick();
  EXPECT_TRUE(simulation.isFinished());
  EXPECT_EQ(simulation.success(), std::optional<bool>(true));
}

TEST(PathFormationRefusalTest, NamesWhatIsNotThere) {
  try {
    Simulation simulation(experiment("<prey>pray</prey>"));
    simulation.start();
    FAIL() << "it was not refused";
  } catch (const std::exception& error) {
    EXPECT_NE(std::string(error.what()).find("path.xml:"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("prey: found 'pray', allowed: the id of an entity; did you mean 'prey'?"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace swarmanoid::test
