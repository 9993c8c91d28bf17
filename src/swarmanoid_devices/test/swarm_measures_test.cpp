// The rules `dispersion` and `taxis`, without engines: their metrics for robots at known positions. With driving
// robots: swarmanoid_experiments/test/aggregation_test.cpp and emergent_taxis_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid::test {
namespace {

using Places = std::vector<std::pair<double, double>>;

std::string measuredFootbot(const std::string& id, double x, double y) {
  return "<footbot id=\"" + id + "\"><position>" + numberText(x) + "," + numberText(y) +
         ",0</position><orientation>0,0,0</orientation></footbot>";
}

/// Footbots fb_1, fb_2, ..., one with a name outside the group, and a lamp.
Experiment world(const std::string& rules, const Places& places) {
  loadPluginLibrary("swarmanoid_devices", {}, {});
  std::string robots = measuredFootbot("other", 9.0, 9.0);
  for (std::size_t i = 0; i < places.size(); ++i) {
    robots += measuredFootbot("fb_" + std::to_string(i + 1), places[i].first, places[i].second);
  }
  return parseExperiment(R"(<ahss-config>
  <framework><clocktick>100</clocktick><maxclock>1000</maxclock></framework>
  <arena size="10,10,3" optimization="2D">
    <light id="lamp"><position>7, 2, 1.3</position><orientation>0, 0, 0</orientation></light>)" +
                             robots + "</arena><rules>" + rules + "</rules></ahss-config>",
                         "measures.xml");
}

class Measured {
 public:
  Measured(const std::string& rule, const Places& places) : simulation(world(rule, places)) {
    simulation.start();
    simulation.tick();
  }
  double metric(const std::string& name) const { return std::get<double>(simulation.metrics().at("r." + name)); }
  void put(const std::string& entity, double x, double y) {
    simulation.apply(MoveEntity{entity, {{x, y, 0.0}, Eigen::Quaterniond::Identity()}});
    simulation.tick();
  }

  Simulation simulation;
};

constexpr const char* kDispersion = "<dispersion id='r'><robots>fb_</robots><radius>0.1</radius></dispersion>";
constexpr const char* kTaxis = "<taxis id='r'><target>lamp</target><robots>fb_</robots></taxis>";

TEST(DispersionTest, TheSecondMomentIsThatOfTheRobotsThatCount) {
  // centroid (2, 3); squared distances 1 + 4, 0.25, 0.25 + 4; squared diameter 0.04
  const Measured measured(kDispersion, {{1.0, 5.0}, {2.5, 3.0}, {2.5, 1.0}});
  EXPECT_NEAR(measured.metric("second_moment"), (5.0 + 0.25 + 4.25) / 0.04, 1e-9);
}

TEST(DispersionTest, RobotsAreOfOneClusterWhereNoThirdOneFitsBetweenThem) {
  // centres 0.39 m from each other form a chain around a corner; the last two are 0.41 m from it, and a pair
  const Measured measured(kDispersion, {{1.0, 1.0}, {1.39, 1.0}, {1.39, 1.39}, {1.80, 1.39}, {1.80, 1.78}});
  EXPECT_NEAR(measured.metric("largest_cluster"), 3.0 / 5.0, 1e-12);
}

TEST(DispersionTest, ARobotThatComesBetweenTwoClustersMakesThemOne) {
  Measured measured(kDispersion, {{1.0, 1.0}, {1.25, 1.0}, {1.75, 1.0}, {2.0, 1.0}, {6.0, 6.0}, {1.5, 7.0}});
  EXPECT_NEAR(measured.metric("largest_cluster"), 2.0 / 6.0, 1e-12);
  measured.put("fb_6", 1.5, 1.0);
  EXPECT_NEAR(measured.metric("largest_cluster"), 5.0 / 6.0, 1e-12);
}

TEST(DispersionTest, WhereNoRobotCountsThereIsNoCluster) {
  const Measured measured(kDispersion, {});
  EXPECT_EQ(measured.metric("largest_cluster"), 0.0);
  EXPECT_EQ(measured.metric("second_moment"), 0.0);
}

TEST(TaxisTest, ProgressIsWhatTheCentroidHasComeNearerSinceTheRunBegan) {
  Measured measured(kTaxis, {{1.0, 2.0}, {2.0, 5.0}, {3.0, 2.0}});
  const double at_first = std::hypot(5.0, 1.0);  // from (2, 3)
  EXPECT_NEAR(measured.metric("distance"), at_first, 1e-12);
  EXPECT_EQ(measured.metric("progress"), 0.0);
  measured.put("fb_2", 5.0, 5.0);  // moves the centroid to (3, 3)
  EXPECT_NEAR(measured.metric("distance"), std::hypot(4.0, 1.0), 1e-12);
  EXPECT_NEAR(measured.metric("progress"), at_first - std::hypot(4.0, 1.0), 1e-12);
  measured.simulation.apply(DeleteEntity{"lamp"});
  measured.put("fb_2", 8.0, 5.0);
  EXPECT_NEAR(measured.metric("distance"), std::hypot(4.0, 1.0), 1e-12) << "the last one that there was";
}

/// Adds a robot like that of the file, with another name and position.
void spawn(Simulation& simulation, const std::string& id, double x, double y) {
  const Experiment& experiment = simulation.experiment();
  const auto is_robot = [](const EntityDescription& entity) { return entity.type == "footbot"; };
  EntityDescription robot = *std::find_if(experiment.arena.entities.begin(), experiment.arena.entities.end(), is_robot);
  robot.id = id;
  robot.position = {x, y, 0.0};
  simulation.apply(SpawnEntity{robot, {}});
  simulation.tick();
}

TEST(TaxisTest, WhoComesOrGoesIsNoProgress) {
  Measured measured(kTaxis, {{1.0, 2.0}, {2.0, 5.0}, {3.0, 2.0}});
  measured.put("fb_2", 5.0, 5.0);  // moves the centroid from (2, 3) to (3, 3)
  const double progress = std::hypot(5.0, 1.0) - std::hypot(4.0, 1.0);
  measured.simulation.apply(DeleteEntity{"fb_1"});
  measured.simulation.tick();
  EXPECT_NEAR(measured.metric("distance"), std::hypot(3.0, 1.5), 1e-12) << "from (4, 3.5)";
  EXPECT_NEAR(measured.metric("progress"), progress, 1e-12);
  spawn(measured.simulation, "fb_4", 2.5, 0.5);
  EXPECT_NEAR(measured.metric("distance"), std::hypot(3.5, 0.5), 1e-12) << "from (3.5, 2.5)";
  EXPECT_NEAR(measured.metric("progress"), progress, 1e-12);
  measured.put("fb_4", 4.0, 0.5);  // moves the centroid to (4, 2.5)
  EXPECT_NEAR(measured.metric("progress"), progress + std::hypot(3.5, 0.5) - std::hypot(3.0, 0.5), 1e-12);
}

TEST(TaxisTest, WithoutRobotsTheLastValuesStay) {
  Measured measured(kTaxis, {{1.0, 2.0}});
  measured.put("fb_1", 3.0, 2.0);
  measured.simulation.apply(DeleteEntity{"fb_1"});
  measured.simulation.tick();
  EXPECT_NEAR(measured.metric("distance"), 4.0, 1e-12) << "and not that of the origin";
  EXPECT_NEAR(measured.metric("progress"), 2.0, 1e-12);
}

TEST(TaxisTest, TheFirstRobotBeginsTheRun) {
  Measured measured(kTaxis, {});
  EXPECT_EQ(measured.metric("distance"), 0.0);
  spawn(measured.simulation, "fb_1", 2.5, 2.0);
  EXPECT_NEAR(measured.metric("distance"), 4.5, 1e-12);
  EXPECT_EQ(measured.metric("progress"), 0.0);
  measured.put("fb_1", 3.2, 2.0);
  EXPECT_NEAR(measured.metric("progress"), 0.7, 1e-12);
}

TEST(TaxisTest, ATargetThatIsNotThereIsRefused) {
  try {
    const Measured measured("<taxis id='r'><target>lamb</target></taxis>", {{1.0, 1.0}});
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_NE(
        std::string(error.what()).find("target: found 'lamb', allowed: the id of an entity; did you mean 'lamp'?"),
        std::string::npos)
        << error.what();
  }
}

TEST(SwarmMeasuresTest, ASteadyTickAllocatesNothing) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  for (const char* rule : {kDispersion, kTaxis}) {
    Measured measured(rule, {{1.0, 1.0}, {1.3, 1.0}, {4.0, 1.0}});
    measured.simulation.tick();
    const long before = heap_allocations;
    measured.simulation.tick();
    EXPECT_EQ(heap_allocations, before) << rule;
  }
}

}  // namespace
}  // namespace swarmanoid::test
