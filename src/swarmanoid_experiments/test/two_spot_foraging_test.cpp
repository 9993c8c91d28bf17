// The installed experiment `two_spot_foraging`: its arena is that of the paper, no robot leaves it, and its behaviour
// machine delivers more items than a random walk, because of the light.
#include <gtest/gtest.h>

#include "installed_experiment.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

const std::string kTransitions = "controllers.bc.parameters.transitions.";
const Eigen::Vector2d kMiddle(2.0, 2.0);
constexpr int kWalls = 12;
constexpr double kHalfWall = 0.025;  // m, half of their thickness

/// Inner face of a wall: its outward normal, and its distance from the centre of the arena.
struct Face {
  Eigen::Vector2d normal;
  double distance = 0.0;  // m
};

std::vector<Face> faces(const Simulation& simulation) {
  std::vector<Face> found;
  for (int i = 1; i <= kWalls; ++i) {
    const Pose& wall = poseOf(simulation, "wall_" + std::to_string(i));
    const Eigen::Vector2d normal = (wall.orientation * Eigen::Vector3d::UnitX()).head<2>();
    found.push_back({normal, normal.dot(wall.position.head<2>() - kMiddle) - kHalfWall});
  }
  return found;
}

TEST(TwoSpotForagingTest, TheArenaIsADodecagonOfThePapersArea) {
  const auto simulation = installed("two_spot_foraging", 1);
  double area = 0.0;
  const std::vector<Face> walls = faces(*simulation);
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const double angle = 2.0 * M_PI * static_cast<double>(i) / kWalls;
    EXPECT_NEAR(walls[i].normal.x(), std::cos(angle), 1e-9);
    EXPECT_NEAR(walls[i].normal.y(), std::sin(angle), 1e-9);
    area += walls[i].distance * walls[i].distance * std::tan(M_PI / kWalls);
  }
  EXPECT_NEAR(area, 4.91, 0.001);
}

TEST(TwoSpotForagingTest, NoRobotPassesAWall) {
  constexpr double kRadius = 0.085;  // m, of a footbot
  const auto simulation = installed("two_spot_foraging", 1);
  const std::vector<Face> walls = faces(*simulation);
  double farthest = -1.0;  // m, beyond the contact with the wall
  while (!simulation->isFinished()) {
    simulation->tick();
    for (int i = 1; i <= 20; ++i) {
      const Eigen::Vector2d place = poseOf(*simulation, "fb_" + std::to_string(i)).position.head<2>() - kMiddle;
      for (const Face& wall : walls) {
        farthest = std::max(farthest, wall.normal.dot(place) + kRadius - wall.distance);
      }
    }
  }
  EXPECT_LT(farthest, 0.0006) << "what dynamics2d promises";
  EXPECT_GT(farthest, -0.01) << "they come to the walls";
}

double items(std::uint64_t seed, const std::vector<std::string>& overrides = {}) {
  const auto simulation = installed("two_spot_foraging", seed, overrides);
  finish(*simulation);
  EXPECT_TRUE(simulation->failures().empty());
  EXPECT_EQ(simulation->space().tick, 1200U) << "120 s";
  return metricOf(*simulation, "items.returns");
}

// A walk that never leaves its first state: the same exploration by the same robots from the same positions.
const std::vector<std::string> kWalk{kTransitions + "found.probability=0", kTransitions + "strayed.probability=0"};
const std::vector<std::string> kDark{"arena.lamp.intensity=0"};

TEST(TwoSpotForagingTest, TheMachineBringsMoreThanARandomWalkAndThanWithoutTheLamp) {
  // over 10 seeds: 28 to 35 items, 31 on average; the walk 14 to 25, 19 on average; in the dark 13 to 20, 16 on average
  constexpr std::uint64_t kSeeds = 4;
  double machine = 0.0;
  double walk = 0.0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    const double found = items(seed);
    const double by_chance = items(seed, kWalk);
    EXPECT_GT(found, by_chance);
    EXPECT_GT(found, items(seed, kDark));
    machine += found / kSeeds;
    walk += by_chance / kSeeds;
  }
  EXPECT_GT(machine, 1.4 * walk);
}

TEST(TwoSpotForagingTest, TheSameSeedGivesTheSameBits) {
  const auto expected = hashesOf(*installed("two_spot_foraging", 4), 200);
  EXPECT_EQ(hashesOf(*installed("two_spot_foraging", 4, {}, 2), 200), expected) << "on two threads";
  EXPECT_NE(hashesOf(*installed("two_spot_foraging", 5), 200), expected) << "another seed";
}

}  // namespace
}  // namespace swarmanoid::test
