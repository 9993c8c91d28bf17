// Drawing the devices of a run does not change the run, bit for bit.
#include <gtest/gtest.h>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"
#include "swarmanoid_space/device_drawing.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid::test {
namespace {

std::unique_ptr<Simulation> runOf(const std::string& experiment) {
  loadBuiltInPlugins();
  auto run = std::make_unique<Simulation>(
      readExperiment(findShared("swarmanoid_experiments", "experiments/" + experiment + ".xml")));
  run->start();
  return run;
}

class DrawnRunTest : public testing::TestWithParam<const char*> {};

TEST_P(DrawnRunTest, IsTheSame) {
  const auto drawn = runOf(GetParam());
  const auto unseen = runOf(GetParam());
  DeviceDrawings drawings;
  std::size_t lines = 0;
  for (int i = 0; i < 60; ++i) {
    drawn->drawDevices(drawings);
    for (const auto& [type, drawing] : drawings.all()) {
      lines += drawing.lines().size();
    }
    drawn->tick();
    unseen->tick();
    ASSERT_EQ(drawn->stateHash(), unseen->stateHash()) << "tick " << i;
    ASSERT_EQ(deepHash(drawn->space()), deepHash(unseen->space())) << "tick " << i;
  }
  EXPECT_GT(lines, 100U) << "there was something to draw";
}

INSTANTIATE_TEST_SUITE_P(Experiments, DrawnRunTest,
                         testing::Values("object_retrieval", "diffusion", "trail", "phototaxis"));

TEST(DrawnRunTest, DrawingAgainAllocatesNothing) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  const auto run = runOf("object_retrieval");
  for (int i = 0; i < 20; ++i) {
    run->tick();
  }
  DeviceDrawings drawings;
  run->drawDevices(drawings);
  EXPECT_FALSE(drawings.of("footbot_proximity").lines().empty());
  const long before = heap_allocations;
  run->drawDevices(drawings);
  EXPECT_EQ(heap_allocations - before, 0);
}

TEST(DrawnRunTest, OfOneRobot) {
  const auto run = runOf("object_retrieval");
  DeviceDrawings drawings(DrawnRobots{false, {"fb_2"}});
  run->drawDevices(drawings);
  EXPECT_EQ(drawings.of("footbot_proximity").lines().size(), 24U);
  EXPECT_TRUE(drawings.of("eyebot_camera").lines().empty());
}

}  // namespace
}  // namespace swarmanoid::test
