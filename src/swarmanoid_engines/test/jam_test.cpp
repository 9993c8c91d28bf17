// Crowds under pressure: no robot leaves the room, none overlaps another, at any time step.
#include "jam.hpp"

#include <gtest/gtest.h>

#include "world.hpp"

namespace swarmanoid::kinematics2d {
namespace {

using namespace jam;

constexpr double kPromised = 2e-9;  // m: the engine's tolerance and rounding

class JamTest : public testing::TestWithParam<JamCase> {};

TEST_P(JamTest, NoRobotLeavesAndNoneOverlapsAnother) {
  World world({25.0, 25.0, 2.0}, GetParam().subclock);
  expectDepths(press(GetParam(), world), kPromised, kPromised);
}

INSTANTIATE_TEST_SUITE_P(Crowds, JamTest,
                         testing::Values(JamCase{"corner", 20, 1, corner}, JamCase{"corner", 1000, 1, corner},
                                         JamCase{"corner", 150, 10, corner}, JamCase{"gate", 200, 4, gate},
                                         JamCase{"ring", 600, 1, ring}, JamCase{"crowd", 300, 2, eachOther}));

}  // namespace
}  // namespace swarmanoid::kinematics2d
