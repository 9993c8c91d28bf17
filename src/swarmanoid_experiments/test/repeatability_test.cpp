// The same experiment with the same seed gives the same result.
#include <gtest/gtest.h>

#include <cstdlib>
#include <vector>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

/// Robots placed and driven at random, with noise: exercises everything that could depend on order or threads.
World busyWorld(int robots, int threads) {
  const int side = robots <= 400 ? 8 : 14;  // [m]; in a smaller arena no free place would be found for the last ones
  const std::string most = std::to_string(side - 0.3);
  World world;
  world.size = std::to_string(side) + "," + std::to_string(side) + ",2";
  world.bounded = true;
  world.ticks = 300;
  world.framework = "<threads>" + std::to_string(threads) + "</threads><random_seed>5</random_seed>";
  world.entities = "<distribute quantity=\"" + std::to_string(robots) +
                   "\" layout=\"uniform\"><minimum>0.3,0.3,0</minimum><maximum>" + most + "," + most +
                   ",0</maximum><footbot id=\"fb\"><controller>drive</controller></footbot></distribute>";
  world.members = member("fb");
  world.drive = "<left>0</left><right>0</right><random>true</random>";
  return world;
}

TEST(RepeatabilityTest, TheSameSeedTwice) {
  auto first = retrieval(7, 1);
  auto second = retrieval(7, 1);
  EXPECT_EQ(hashesOf(*first, 400), hashesOf(*second, 400));
}

TEST(RepeatabilityTest, AnotherSeedIsAnotherRun) {
  auto first = retrieval(7, 1);
  auto second = retrieval(8, 1);
  EXPECT_NE(hashesOf(*first, 50), hashesOf(*second, 50));
}

TEST(RepeatabilityTest, AnyNumberOfThreads) {
  auto alone = busyWorld(400, 1).make();
  alone->start();
  const auto expected = hashesOf(*alone, 100);
  for (const int threads : {2, 4, 8}) {
    auto together = busyWorld(400, threads).make();
    together->start();
    EXPECT_EQ(hashesOf(*together, 100), expected) << threads << " threads";
  }
}

/// Two engines in one plane; each moves half of the robots, and the other half block their way as mirrors.
std::unique_ptr<Simulation> mirroringWorld(bool is_ground_first, int threads) {
  World world;
  world.size = "3,3,2";
  world.bounded = true;
  world.framework = "<threads>" + std::to_string(threads) + "</threads>";
  for (const char* id : {"fb", "gb"}) {
    world.entities += std::string(
                          "<distribute quantity=\"20\" layout=\"uniform\"><minimum>0.2,0.2,0</minimum><maximum>2.8,"
                          "2.8,0</maximum><footbot id=\"") +
                      id + "\"><controller>drive</controller></footbot></distribute>";
  }
  world.members = R"(<entity id="fb" role="move"/><entity id="gb" role="mirror"/></engine>)"
                  R"(<engine id="other"><entity id="fb" role="mirror"/><entity id="gb" role="move"/>)";
  world.drive = "<left>0</left><right>0</right><random>true</random>";
  std::string xml = world.xml();
  const std::string ground = "<kinematics2d id=\"ground\"></kinematics2d>";
  const std::string other = "<kinematics2d id=\"other\"></kinematics2d>";
  xml.replace(xml.find(ground), ground.size(), is_ground_first ? ground + other : other + ground);
  loadBuiltInPlugins();
  auto simulation = std::make_unique<Simulation>(parseExperiment(xml, "test.xml"));
  simulation->start();
  return simulation;
}

TEST(RepeatabilityTest, MirrorsDoNotDependOnWhichEngineMovesFirst) {
  const auto expected = hashesOf(*mirroringWorld(true, 1), 100);
  EXPECT_EQ(hashesOf(*mirroringWorld(false, 1), 100), expected);
  EXPECT_EQ(hashesOf(*mirroringWorld(true, 2), 100), expected);
}

TEST(RepeatabilityTest, WatchingChangesNothing) {
  World world = busyWorld(20, 1);
  auto alone = world.make();
  alone->start();
  const auto expected = hashesOf(*alone, 100);
  world.visualisations =
      "<text_render id=\"t\"><file>/dev/null</file></text_render><debug_render id=\"d\"><file>/dev/null</file>"
      "</debug_render><hash_recorder id=\"h\"><file>/dev/null</file></hash_recorder>";
  auto watched = world.make();
  watched->start();
  EXPECT_EQ(hashesOf(*watched, 100), expected);
}

EntityDescription newcomer(int number, double x, double y) {
  EntityDescription entity;
  entity.type = "footbot";
  entity.id = "late_" + std::to_string(number);
  entity.position = {x, y, 0};
  entity.controller = "drive";
  return entity;
}

/// Deletes every second robot during the run, and spawns new ones in free places. @return the hashes afterwards
std::vector<std::uint64_t> lifeAndDeath(int robots) {
  auto simulation = busyWorld(robots, 1).make();
  simulation->start();
  hashesOf(*simulation, 20);
  const auto commandOf = [&](int i) {
    const Space& space = simulation->space();
    return space.commands.find<FootbotWheels>(space.entities.find("fb_" + std::to_string(i)));
  };
  std::vector<const FootbotWheels*> before;
  for (int i = 1; i <= robots; i += 2) {
    before.push_back(commandOf(i));
  }
  for (int i = 2; i <= robots; i += 2) {
    simulation->apply(DeleteEntity{"fb_" + std::to_string(i)});
  }
  for (int i = 0; i < robots / 4; ++i) {
    try {
      simulation->apply(SpawnEntity{newcomer(i, 0.4 + 0.4 * (i % 18), 0.4 + 0.4 * (i / 18)), {"ground"}});
    } catch (const ConfigError&) {
      // the place is occupied; these places are the same in every run
    }
  }
  const auto hashes = hashesOf(*simulation, 50);
  // the pointers of the remaining controllers are still valid
  for (int i = 1; i <= robots; i += 2) {
    EXPECT_EQ(commandOf(i), before[static_cast<std::size_t>(i / 2)]);
  }
  EXPECT_TRUE(simulation->failures().empty());
  return hashes;
}

TEST(LifeCycleTest, DeletingAndSpawningIsRepeatable) {
  const int robots = std::getenv("SWARMANOID_LONG_TESTS") != nullptr ? 1000 : 200;
  const auto first = lifeAndDeath(robots);
  EXPECT_EQ(first.size(), 50U);
  EXPECT_EQ(first, lifeAndDeath(robots));
}

TEST(LifeCycleTest, ManyCyclesLeaveNothingBehind) {
  auto simulation = busyWorld(5, 1).make();
  simulation->start();
  const std::size_t rows = simulation->space().entities.rowCount();
  for (int i = 0; i < 1000; ++i) {
    simulation->apply(DeleteEntity{"fb_3"});
    EntityDescription again = newcomer(0, 4, 4);
    again.id = "fb_3";
    try {
      simulation->apply(SpawnEntity{again, {"ground"}});
    } catch (const ConfigError&) {
      again.position = {2, 2, 0};
      simulation->apply(SpawnEntity{again, {"ground"}});
    }
    simulation->tick();
  }
  EXPECT_EQ(simulation->space().entities.rowCount(), rows);
  EXPECT_EQ(simulation->robotCount(), 5U);
}

TEST(InterventionTest, WhatCannotBeIsRefusedAndNothingChanges) {
  auto simulation = busyWorld(5, 1).make();
  simulation->start();
  const std::uint64_t hash = simulation->stateHash();
  EXPECT_THROW(simulation->apply(DeleteEntity{"nobody"}), ConfigError);
  EXPECT_THROW(simulation->apply(SpawnEntity{newcomer(1, 0.0, 0.0), {"ground"}}), ConfigError);  // inside the wall
  EXPECT_THROW(simulation->apply(SpawnEntity{newcomer(1, 4.0, 4.0), {"sky"}}), ConfigError);
  EXPECT_THROW(simulation->apply(MoveEntity{"fb_1", Pose{{0, 0, 0}, Eigen::Quaterniond::Identity()}}), ConfigError);
  EXPECT_THROW(simulation->apply(MoveEntity{"fb_1", Pose{{4, 4, 1}, Eigen::Quaterniond::Identity()}}), ConfigError);
  EXPECT_EQ(simulation->stateHash(), hash);
}

/// Two driving robots; the controller of fb_a throws in tick 10.
std::unique_ptr<Simulation> oneThrows() {
  World world;
  world.entities = footbot("fb_a", 2, 3, 0) + footbot("fb_b", 2, 5, 0);
  world.members = member("fb_a") + member("fb_b");
  world.drive = "<left>2</left><right>2</right><throw_at>10</throw_at><only>fb_a</only>";
  auto simulation = world.make();
  simulation->start();
  return simulation;
}

TEST(FailureTest, AThrowingControllerStopsItsRobotAndNoOther) {
  auto simulation = oneThrows();
  while (!simulation->isFinished()) {
    simulation->tick();
  }
  ASSERT_EQ(simulation->failures().size(), 1U);
  EXPECT_EQ(simulation->failures()[0].robot, "fb_a");
  EXPECT_EQ(simulation->failures()[0].tick, 10U);
  EXPECT_EQ(simulation->failures()[0].reason, "told to");
  EXPECT_NEAR(poseOf(*simulation, "fb_a").position.x(), 2 + 10 * 0.1 * 2 * 0.029, 1e-9);
  EXPECT_NEAR(poseOf(*simulation, "fb_b").position.x(), 2 + 100 * 0.1 * 2 * 0.029, 1e-9);
}

TEST(FailureTest, WhoHasTheNameOfOneThatFailedIsHealthy) {
  auto simulation = oneThrows();
  const auto hasFailed = [&](const char* robot) {
    return simulation->controllerStatus(simulation->space().entities.find(robot)).value().has_failed;
  };
  EXPECT_FALSE(hasFailed("fb_a"));
  hashesOf(*simulation, 20);
  EXPECT_TRUE(hasFailed("fb_a"));
  EXPECT_FALSE(hasFailed("fb_b"));
  simulation->apply(DeleteEntity{"fb_a"});
  EntityDescription successor;
  successor.type = "footbot";
  successor.id = "fb_a";
  successor.position = {2, 3, 0};
  successor.controller = "drive";
  simulation->apply(SpawnEntity{successor, {"ground"}});
  EXPECT_FALSE(hasFailed("fb_a"));
  EXPECT_EQ(simulation->failures().size(), 1U) << "of the run it stays one";
}

TEST(FailureTest, ANumberThatIsNoneStopsTheRobotInTheSameTick) {
  World world;
  world.entities = footbot("fb", 2, 3, 0);
  world.members = member("fb");
  world.drive = "<left>2</left><right>2</right><nan_at>4</nan_at>";
  auto simulation = world.make();
  simulation->start();
  while (!simulation->isFinished()) {
    simulation->tick();
  }
  ASSERT_EQ(simulation->failures().size(), 1U);
  EXPECT_EQ(simulation->failures()[0].tick, 4U);
  EXPECT_EQ(simulation->failures()[0].reason, "commanded a number that is not finite");
  EXPECT_NEAR(poseOf(*simulation, "fb").position.x(), 2 + 4 * 0.1 * 2 * 0.029, 1e-9);
  EXPECT_TRUE(poseOf(*simulation, "fb").position.allFinite());
}

TEST(RetrievalTest, ThePreyThatWasChosenEndsInTheNest) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    auto simulation = retrieval(seed, 1);
    while (!simulation->isFinished()) {
      simulation->tick();
    }
    EXPECT_EQ(simulation->success(), true) << "seed " << seed;
    EXPECT_LT(simulation->space().tick, 6000U);
  }
}

}  // namespace
}  // namespace swarmanoid::test
