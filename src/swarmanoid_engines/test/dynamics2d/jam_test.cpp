// Crowds under pressure: no robot leaves the room, none is deep in another.
#include "../jam.hpp"

#include <gtest/gtest.h>

#include "world.hpp"

namespace swarmanoid::dynamics2d {
namespace {

using namespace jam;

constexpr double kPromised = 6e-4;  // m: the limit in the documentation

class JamTest : public testing::TestWithParam<JamCase> {};

TEST_P(JamTest, NoRobotLeavesAndNoneIsDeepInAnother) {
  World world({25.0, 25.0, 2.0}, GetParam().subclock);
  const Depths depths = press(GetParam(), world);
  expectDepths(depths, kPromised, kPromised);
  EXPECT_GT(depths.in_others, 1e-6) << "they do not press";
}

INSTANTIATE_TEST_SUITE_P(Crowds, JamTest,
                         testing::Values(JamCase{"corner", 20, 1, corner}, JamCase{"corner", 150, 1, corner},
                                         JamCase{"corner", 500, 10, corner}, JamCase{"corner", 70, 10, corner},
                                         JamCase{"gate", 60, 4, gate}, JamCase{"ring", 90, 1, ring},
                                         JamCase{"crowd", 120, 1, eachOther}));

}  // namespace
}  // namespace swarmanoid::dynamics2d
