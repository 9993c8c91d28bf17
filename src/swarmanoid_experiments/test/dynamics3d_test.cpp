// The object retrieval experiment with masses, forces and friction.
#include <gtest/gtest.h>

#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

constexpr const char* kExperiment = "object_retrieval_3d";
constexpr std::uint64_t kTicks = 6000;

TEST(Dynamics3dTest, ThePreyIsBroughtHome) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    auto simulation = retrieval(seed, 1, kExperiment);
    hashesOf(*simulation, kTicks);
    EXPECT_EQ(simulation->success(), true) << "seed " << seed;
    EXPECT_TRUE(simulation->failures().empty());
  }
}

TEST(Dynamics3dTest, OneSeedIsOneRunOnAnyNumberOfThreads) {
  auto alone = retrieval(7, 1, kExperiment);
  const auto expected = hashesOf(*alone, 300);
  for (const int threads : {1, 2, 4}) {
    auto again = retrieval(7, threads, kExperiment);
    EXPECT_EQ(hashesOf(*again, 300), expected) << threads << " threads";
  }
}

TEST(Dynamics3dTest, AResetIsAFreshStart) {
  auto fresh = retrieval(3, 1, kExperiment);
  const auto expected = hashesOf(*fresh, kTicks);
  auto used = retrieval(3, 1, kExperiment);
  for (const std::uint64_t ticks : {0, 37, 400}) {
    hashesOf(*used, ticks);
    used->reset();
    ASSERT_EQ(hashesOf(*used, 100), std::vector<std::uint64_t>(expected.begin(), expected.begin() + 100));
  }
  used->reset();
  EXPECT_EQ(hashesOf(*used, kTicks), expected);
}

TEST(Dynamics3dTest, StepsThatAreTooLongAreRefusedAtLoad) {
  loadBuiltInPlugins();
  const std::string xml =
      R"(<ahss-config><framework><clocktick>100</clocktick><maxclock>10</maxclock></framework>
<arena size="3,3,2" optimization="2D"><footbot id="fb"><position>1,1,0</position><orientation>0,0,0</orientation>
</footbot></arena>
<engines><dynamics3d id="ground"><subclock>5</subclock></dynamics3d></engines>
<arena_physics><engine id="ground"><entity id="fb"/></engine></arena_physics></ahss-config>)";
  try {
    const Simulation simulation(parseExperiment(xml, "coarse.xml"));
    FAIL() << "it was not refused";
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(),
                 "coarse.xml:4: dynamics3d 'ground': subclock: found 5 with ticks of 100 ms, which makes steps of 20 "
                 "ms; allowed: steps of at most 10 ms, here a subclock from 10");
  }
}

}  // namespace
}  // namespace swarmanoid::test
