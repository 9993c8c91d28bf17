// The rule `flock`, without engines: order and spread of robots at given poses, and the speed of their centre. With
// driving robots: swarmanoid_experiments/test/flocking_test.cpp.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid::test {
namespace {

constexpr double kFlockDegree = M_PI / 180.0;

std::string flockFootbot(const std::string& id, const std::string& position, const std::string& heading_deg) {
  return "<footbot id=\"" + id + "\"><position>" + position + ", 0</position><orientation>0, 0, " + heading_deg +
         "</orientation></footbot>";
}

/// Ticks of 0.1 s; three robots in the group, with the centre (2, 1.5), and one outside the group.
class FlockTest : public testing::Test {
 protected:
  FlockTest() { simulation->start(); }

  double metric(const std::string& name) const { return std::get<double>(simulation->metrics().at("f." + name)); }

  void put(const std::string& robot, double x, double y, double heading) {
    simulation->apply(
        MoveEntity{robot, {{x, y, 0.0}, Eigen::Quaterniond(Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ()))}});
  }

  static std::unique_ptr<Simulation> make() {
    loadPluginLibrary("swarmanoid_devices", {}, {});
    return std::make_unique<Simulation>(parseExperiment(R"(<ahss-config>
  <framework><clocktick>100</clocktick><maxclock>1000</maxclock></framework>
  <arena size="5,5,3" optimization="2D">)" + flockFootbot("fb_1", "1, 1", "20") +
                                                            flockFootbot("fb_2", "2, 1", "110") +
                                                            flockFootbot("fb_3", "3, 2.5", "-35") +
                                                            flockFootbot("other", "4, 4", "180") + R"(</arena>
  <rules><flock id="f"><robots>fb_</robots><settling>0.5</settling></flock></rules></ahss-config>)",
                                                        "flock.xml"));
  }

  const std::unique_ptr<Simulation> simulation = make();
};

TEST_F(FlockTest, OrderIsTheLengthOfTheMeanHeading) {
  simulation->tick();
  const double east = std::cos(20.0 * kFlockDegree) + std::cos(110.0 * kFlockDegree) + std::cos(35.0 * kFlockDegree);
  const double north = std::sin(20.0 * kFlockDegree) + std::sin(110.0 * kFlockDegree) - std::sin(35.0 * kFlockDegree);
  EXPECT_NEAR(metric("order"), std::hypot(east, north) / 3.0, 1e-12);
  for (const char* robot : {"fb_1", "fb_2", "fb_3"}) {
    put(robot, 1.0, 1.0, 2.2);
  }
  simulation->tick();
  EXPECT_NEAR(metric("order"), 1.0, 1e-12) << "all alike";
  put("fb_1", 1.0, 1.0, 2.2 + 120.0 * kFlockDegree);
  put("fb_2", 1.0, 1.0, 2.2 - 120.0 * kFlockDegree);
  simulation->tick();
  EXPECT_NEAR(metric("order"), 0.0, 1e-12) << "a star of three";
}

TEST_F(FlockTest, SpreadIsTheMeanDistanceFromTheCentre) {
  simulation->tick();
  EXPECT_NEAR(metric("spread"), (std::hypot(1.0, 0.5) + 0.5 + std::hypot(1.0, 1.0)) / 3.0, 1e-12);
}

TEST_F(FlockTest, MeansAreThoseOfTheTicksAfterSettling) {
  for (int tick = 0; tick < 4; ++tick) {  // the fifth tick ends at 0.5 s
    simulation->tick();
    EXPECT_EQ(metric("mean_order"), 0.0) << tick;
  }
  simulation->tick();
  const double first = metric("order");
  EXPECT_NEAR(metric("mean_order"), first, 1e-12);
  EXPECT_EQ(metric("speed"), 0.0);
  put("fb_3", 3.3, 2.1, -35.0 * kFlockDegree);  // moves the centre by a third of (0.3, -0.4)
  simulation->tick();
  EXPECT_NEAR(metric("speed"), 0.5 / 3.0 / 0.1, 1e-9);
  put("fb_3", 3.3, 2.1, 110.0 * kFlockDegree);
  simulation->tick();
  EXPECT_NEAR(metric("speed"), 0.5 / 3.0 / 0.2, 1e-9) << "over two ticks";
  EXPECT_NEAR(metric("mean_order"), (2.0 * first + metric("order")) / 3.0, 1e-12);
}

TEST_F(FlockTest, WhoComesOrGoesIsNoMotion) {
  for (int tick = 0; tick < 5; ++tick) {
    simulation->tick();
  }
  put("fb_3", 3.3, 2.1, -35.0 * kFlockDegree);  // moves the centre by a third of (0.3, -0.4)
  simulation->tick();
  const double speed = metric("speed");
  EXPECT_NEAR(speed, 0.5 / 3.0 / 0.1, 1e-9);
  simulation->apply(DeleteEntity{"fb_1"});  // moves the centre to (2.65, 1.55)
  simulation->tick();
  EXPECT_EQ(metric("speed"), speed);
  put("fb_2", 1.4, 0.8, 110.0 * kFlockDegree);  // moves the centre by half of (-0.6, -0.2)
  simulation->tick();
  EXPECT_NEAR(metric("speed"), std::hypot(0.1 - 0.3, -0.4 / 3.0 - 0.1) / 0.2, 1e-9);
  EntityDescription another = simulation->experiment().arena.entities.front();
  another.id = "fb_4";
  another.position = {4.5, 0.5, 0.0};
  simulation->apply(SpawnEntity{another, {}});
  const double last = metric("speed");
  simulation->tick();
  EXPECT_EQ(metric("speed"), last);
  simulation->tick();
  EXPECT_NEAR(metric("speed"), last * 0.2 / 0.3, 1e-9) << "a tick at rest";
}

TEST_F(FlockTest, ASteadyTickAllocatesNothing) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  for (int tick = 0; tick < 6; ++tick) {
    simulation->tick();
  }
  const long before = heap_allocations;
  simulation->tick();
  EXPECT_EQ(heap_allocations, before);
}

TEST_F(FlockTest, WithoutRobotsAllIsZeroAndAResetBeginsAnew) {
  for (int tick = 0; tick < 8; ++tick) {
    simulation->tick();
  }
  const double mean = metric("mean_order");
  for (const char* robot : {"fb_1", "fb_2", "fb_3"}) {
    simulation->apply(DeleteEntity{robot});
  }
  simulation->tick();
  EXPECT_EQ(metric("order"), 0.0);
  EXPECT_EQ(metric("spread"), 0.0);
  EXPECT_EQ(metric("mean_order"), mean) << "the mean stays";
  simulation->reset();
  EXPECT_EQ(metric("mean_order"), 0.0);
  simulation->tick();
  EXPECT_GT(metric("order"), 0.0);
}

}  // namespace
}  // namespace swarmanoid::test
