// Cameras with more blobs than they can report: overflows are counted, reported once, cleared by a reset, with any
// number of threads.
#include <gtest/gtest.h>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

/// Three footbots among lit preys, each with a camera limited to two blobs.
std::unique_ptr<Simulation> crowd(int threads) {
  World world;
  world.ticks = 20;
  world.framework = "<threads>" + std::to_string(threads) + "</threads>";
  for (int i = 0; i < 3; ++i) {
    const std::string name = std::to_string(i);
    world.entities += footbot("fb_" + name, 1.0, 1.0 + 0.5 * i, 0.0) + "<cylindric_prey id=\"prey_" + name +
                      "\"><position>2," + std::to_string(1.0 + 0.5 * i) +
                      ",0</position><orientation>0,0,0</orientation><radius>0.05</radius><height>0.1</height>"
                      "</cylindric_prey>";
    world.members += member("fb_" + name) + member("prey_" + name);
  }
  std::string xml = world.xml();
  const std::string sensors = "<sensors>";
  xml.insert(xml.find(sensors) + sensors.size(), "<footbot_camera><max_blobs>2</max_blobs></footbot_camera>");
  loadBuiltInPlugins();
  auto simulation = std::make_unique<Simulation>(parseExperiment(xml, "test.xml"));
  simulation->start();
  return simulation;
}

struct Said {
  LogLevel level;
  std::string robot;
  std::string text;
};

std::vector<Said> runToEnd(Simulation& simulation) {
  std::vector<Said> said;
  simulation.setLogSink([&said](LogLevel level, const std::string& robot, const std::string& text) {
    said.push_back({level, robot, text});
  });
  while (!simulation.isFinished()) {
    simulation.tick();
  }
  simulation.setLogSink({});
  return said;
}

void expectThree(const Simulation& simulation, const std::vector<Said>& said) {
  const std::vector<Overflow>& overflows = simulation.space().overflows;
  ASSERT_EQ(overflows.size(), 3U);
  ASSERT_EQ(said.size(), 3U) << "once a device, not once a tick";
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(overflows[i].robot, "fb_" + std::to_string(i));
    EXPECT_EQ(overflows[i].device, "footbot_camera");
    EXPECT_EQ(overflows[i].first_tick, 0U);
    EXPECT_EQ(overflows[i].readings, 20U);
    EXPECT_EQ(said[i].level, LogLevel::kWarning);
    EXPECT_EQ(said[i].robot, overflows[i].robot);
    EXPECT_EQ(said[i].text,
              "footbot_camera: more than 2 blobs in sight in tick 0, the rest is left out; this is said once");
  }
}

TEST(OverflowTest, IsCountedAndSaidOnceADeviceOnAnyNumberOfThreads) {
  auto alone = crowd(1);
  expectThree(*alone, runToEnd(*alone));
  auto together = crowd(4);
  expectThree(*together, runToEnd(*together));
  EXPECT_EQ(together->stateHash(), alone->stateHash());
}

TEST(OverflowTest, AllocatesNothingOnceItIsSaid) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  auto simulation = crowd(1);
  while (simulation->space().tick < 10) {
    simulation->tick();
  }
  const long before = heap_allocations;
  simulation->tick();
  EXPECT_EQ(heap_allocations, before);
  EXPECT_EQ(simulation->space().overflows.at(0).readings, 11U);
}

TEST(OverflowTest, IsForgottenByAReset) {
  auto simulation = crowd(1);
  runToEnd(*simulation);
  simulation->reset();
  EXPECT_TRUE(simulation->space().overflows.empty());
  expectThree(*simulation, runToEnd(*simulation));
}

TEST(OverflowTest, IsKeptWhenItsRobotIsDeleted) {
  auto simulation = crowd(1);
  simulation->tick();
  simulation->apply(DeleteEntity{"fb_1"});
  runToEnd(*simulation);
  ASSERT_EQ(simulation->space().overflows.size(), 3U);
  EXPECT_EQ(simulation->space().overflows[1].robot, "fb_1");
  EXPECT_EQ(simulation->space().overflows[1].readings, 1U);
}

}  // namespace
}  // namespace swarmanoid::test
