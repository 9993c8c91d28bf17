// Crowds under pressure: no robot leaves the room, none is deep in another, none climbs over another.
#include "../jam.hpp"

#include <gtest/gtest.h>

#include "world.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using namespace jam;

constexpr double kInWall = 6e-4;      // m
constexpr double kInOthers = 1.5e-3;  // m: the limit for crowds in the documentation

class JamTest : public testing::TestWithParam<JamCase> {};

TEST_P(JamTest, NoRobotLeavesAndNoneIsDeepInAnother) {
  World world({{"subclock", std::to_string(GetParam().subclock)}});
  world.space.size = {25.0, 25.0, 2.0};
  expectDepths(press(GetParam(), world, 100), kInWall, kInOthers);
  for (const Row row : world.space.entities.order) {
    if (world.space.entities.model[row]->is_movable) {
      EXPECT_LT(world.pose(row).position.z(), 5e-3);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Crowds, JamTest,
                         testing::Values(JamCase{"corner", 20, 10, corner}, JamCase{"corner", 40, 10, corner},
                                         JamCase{"corner", 150, 10, corner}, JamCase{"gate", 60, 10, gate},
                                         JamCase{"ring", 50, 10, ring}, JamCase{"crowd", 60, 10, eachOther}));

}  // namespace
}  // namespace swarmanoid::dynamics3d
