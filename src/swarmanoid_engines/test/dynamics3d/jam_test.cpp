// Crowds that press: no robot leaves the room, none is deep in another, none climbs over another. An island that is too
// large for the exact solver is left to the iterative one.
#include "../jam.hpp"

#include <gtest/gtest.h>

#include "world.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using namespace jam;

constexpr double kInWall = 6e-4;      // m
constexpr double kInOthers = 1.5e-3;  // m: what the pages promise of crowds

class JamTest : public testing::TestWithParam<JamCase> {};

TEST_P(JamTest, NoRobotLeavesAndNoneIsDeepInAnother) {
  World world({{"subclock", std::to_string(GetParam().subclock)}});
  const Depths depths = press(GetParam(), world, 100);
  EXPECT_LT(depths.in_wall, kInWall);
  EXPECT_LT(depths.in_others, kInOthers);
  EXPECT_GT(depths.in_wall, -0.2) << "they do not press";
  for (const Row row : world.space.entities.order) {
    if (world.space.entities.model[row]->is_movable) {
      EXPECT_LT(world.pose(row).position.z(), 5e-3);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Crowds, JamTest,
                         testing::Values(JamCase{"corner", 20, 10, corner}, JamCase{"corner", 40, 10, corner},
                                         JamCase{"gate", 60, 4, gate}, JamCase{"ring", 50, 10, ring},
                                         JamCase{"crowd", 60, 10, eachOther}));

}  // namespace
}  // namespace swarmanoid::dynamics3d
