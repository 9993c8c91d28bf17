// The object retrieval experiment with its footbots and preys in each engine that can hold them: nothing else changes.
#include <gtest/gtest.h>

#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

class EnginesTest : public testing::TestWithParam<GroundEngine> {
 protected:
  std::unique_ptr<Simulation> start(std::uint64_t seed, int threads = 1) {
    return retrieval(seed, threads, GetParam());
  }
};

TEST_P(EnginesTest, ThePreyThatWasChosenEndsInTheNest) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    auto simulation = start(seed);
    while (!simulation->isFinished()) {
      simulation->tick();
    }
    EXPECT_EQ(simulation->success(), true) << "seed " << seed;
  }
}

TEST_P(EnginesTest, TheSameSeedGivesTheSameBits) {
  const auto expected = hashesOf(*start(5), 400);
  EXPECT_EQ(hashesOf(*start(5), 400), expected);
  EXPECT_EQ(hashesOf(*start(5, 2), 400), expected) << "on two threads";
}

TEST_P(EnginesTest, AResetIsAFreshStart) {
  const auto expected = hashesOf(*start(6), 6000);
  auto used = start(6);
  hashesOf(*used, expected.size() - 100);  // a prey is carried by then
  used->reset();
  EXPECT_EQ(hashesOf(*used, 6000), expected);
}

std::string nameOf(const testing::TestParamInfo<GroundEngine>& info) { return info.param.label; }

INSTANTIATE_TEST_SUITE_P(All, EnginesTest,
                         testing::Values(GroundEngine{"kinematics2d", 1}, GroundEngine{"dynamics2d", 4}), nameOf);

}  // namespace
}  // namespace swarmanoid::test
