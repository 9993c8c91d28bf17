// Many worlds of one experiment in C++: a steady step does not use the heap, and the number of threads changes no bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"
#include "swarmanoid_space/worlds/worlds.hpp"

namespace swarmanoid::test {
namespace {

constexpr std::size_t kWorlds = 19;

Worlds makeWorlds(std::size_t threads) {
  loadBuiltInPlugins();
  Experiment experiment = readExperiment(findShared("swarmanoid_experiments", "experiments/diffusion.xml"),
                                         {{"arena.distribute.quantity", "6"},
                                          {"arena.size", "3.7, 3.9, 1"},
                                          {"arena.distribute.minimum", "0.2, 0.2, 0"},
                                          {"arena.distribute.maximum", "3.5, 3.7, 0"}});
  Worlds::Options options;
  options.count = kWorlds;
  options.observations = {"footbot_proximity.value"};
  options.actions = {"footbot_wheels.left", "footbot_wheels.right"};
  options.threads = threads;
  return {std::move(options), [&](std::size_t world) {
            Experiment one = experiment;
            one.framework.seed = 31 + world;
            return one;
          }};
}

/// Turns where an obstacle is near.
void choose(Worlds& worlds, std::vector<float>& actions) {
  const std::size_t numbers = worlds.observationSize();
  for (std::size_t agent = 0; agent < worlds.count() * worlds.slots(); ++agent) {
    const float* seen = worlds.observations() + agent * numbers;
    const bool is_near = *std::max_element(seen, seen + numbers) > 0.0F;
    actions[2 * agent] = is_near ? -3.5F : 4.25F;
    actions[2 * agent + 1] = is_near ? 3.0F : 4.5F;
  }
}

TEST(WorldsTest, AStepAllocatesNothing) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  Worlds worlds = makeWorlds(1);
  std::vector<float> actions(kWorlds * worlds.slots() * worlds.actionSize());
  float nearest = 0.0F;
  for (int step = 0; step < 400; ++step) {
    choose(worlds, actions);
    const long before = heap_allocations;
    worlds.step(actions.data());
    const long after = heap_allocations;
    if (step >= 250) {
      EXPECT_EQ(after - before, 0) << "step " << step;
      nearest = std::max(nearest, *std::max_element(worlds.observations(), worlds.observations() + kWorlds * 6 * 24));
    }
  }
  EXPECT_GT(heap_allocations, 1000) << "the counting works";
  EXPECT_GT(nearest, 0.3F) << "robots meet walls and each other";
}

TEST(WorldsTest, ThreadsChangeNoBit) {
  Worlds one = makeWorlds(1);
  Worlds three = makeWorlds(3);
  ASSERT_EQ(one.slots(), 6U);
  ASSERT_EQ(one.observationSize(), 24U);
  std::vector<float> actions(kWorlds * one.slots() * one.actionSize());
  for (int step = 0; step < 203; ++step) {
    choose(one, actions);
    one.step(actions.data());
    three.step(actions.data());
  }
  for (std::size_t world = 0; world < kWorlds; ++world) {
    EXPECT_EQ(one.world(world).stateHash(), three.world(world).stateHash()) << world;
  }
  EXPECT_NE(one.world(3).stateHash(), one.world(4).stateHash());
}

}  // namespace
}  // namespace swarmanoid::test
