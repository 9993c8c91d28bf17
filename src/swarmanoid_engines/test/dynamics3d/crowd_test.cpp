// Crowds, mirrors placed onto robots, sudden commands: speeds stay bounded, and the same run gives the same bits.
#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "world.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;

/// Footbots packed within walls, and preys among them.
struct Crowd {
  explicit Crowd(int side, World::Values values = {}) : world(values) {
    const double edge = 0.25 * side;
    for (const double x : {-0.05, edge + 0.05}) {
      world.addBlock({0.1, edge + 0.2, 0.4}, 0.0, flatPose(x, edge / 2.0, 0.0, 0.2));
      world.addBlock({edge, 0.1, 0.4}, 0.0, flatPose(edge / 2.0, x, 0.0, 0.2));
    }
    for (int i = 0; i < side * side; ++i) {
      const double x = 0.25 * (i % side) + 0.125;
      const double y = 0.25 * (i / side) + 0.125;
      if (i % 5 == 4) {
        preys.push_back(world.addPrey(0.06, 0.1, 0.3, x, y));
      } else {
        footbots.push_back(world.addFootbot(flatPose(x, y, 0.9 * i)));
      }
    }
  }

  void command(int tick) {
    for (std::size_t i = 0; i < footbots.size(); ++i) {
      const auto k = static_cast<double>(i);
      world.drive(footbots[i], 0.3 * std::sin(0.9 * k + 0.35 * tick), 3.0 * std::cos(1.3 * k + 0.2 * tick));
      world.setGripper(footbots[i], (static_cast<int>(i) + tick / 8) % 3 == 0);
    }
  }

  void expectSane(int tick) const {
    for (const Row row : world.space.entities.order) {
      const Twist& twist = world.twist(row);
      ASSERT_TRUE(world.pose(row).position.allFinite() && twist.linear.allFinite() && twist.angular.allFinite());
      ASSERT_LT(twist.linear.norm(), 2.0) << "entity " << toIndex(row) << ", tick " << tick;
      ASSERT_LT(twist.angular.norm(), 40.0) << "entity " << toIndex(row) << ", tick " << tick;
      if (world.space.entities.model[row]->is_movable) {
        ASSERT_GT(world.pose(row).position.z(), -0.05) << "entity " << toIndex(row) << ", tick " << tick;
        ASSERT_LT(world.pose(row).position.z(), 0.3) << "entity " << toIndex(row) << ", tick " << tick;
      }
    }
  }

  World world;
  std::vector<Row> footbots;
  std::vector<Row> preys;
};

TEST(CrowdTest, ADenseCrowdStaysBounded) {
  Crowd crowd(6);
  for (int tick = 0; tick < 150; ++tick) {
    crowd.command(tick);
    crowd.world.step();
    ASSERT_NO_FATAL_FAILURE(crowd.expectSane(tick));
  }
}

TEST(CrowdTest, TheIterativeSolverStaysBoundedToo) {
  Crowd crowd(6, {{"solver", "iterative"}});
  for (int tick = 0; tick < 150; ++tick) {
    crowd.command(tick);
    crowd.world.step();
    ASSERT_NO_FATAL_FAILURE(crowd.expectSane(tick));
  }
}

std::vector<std::uint64_t> hashesOf(Crowd& crowd, int ticks) {
  std::vector<std::uint64_t> hashes;
  for (int tick = 0; tick < ticks; ++tick) {
    crowd.command(tick);
    crowd.world.step();
    hashes.push_back(stateHash(crowd.world.space));
  }
  return hashes;
}

TEST(CrowdTest, TheSameRunGivesTheSameBits) {
  for (const char* solver : {"exact", "iterative"}) {
    Crowd first(4, {{"solver", solver}});
    const auto expected = hashesOf(first, 60);
    Crowd second(4, {{"solver", solver}});
    EXPECT_EQ(hashesOf(second, 60), expected) << solver;
  }
}

TEST(CrowdTest, WorldsThatRunAtTheSameTimeDoNotDisturbEachOther) {
  for (const char* solver : {"exact", "iterative"}) {
    Crowd alone(4, {{"solver", solver}});
    const auto expected = hashesOf(alone, 30);
    std::vector<std::vector<std::uint64_t>> hashes(3);
    std::vector<std::thread> threads;
    for (auto& each : hashes) {
      threads.emplace_back([&each, solver] {
        Crowd crowd(4, {{"solver", solver}});
        each = hashesOf(crowd, 30);
      });
    }
    for (std::thread& thread : threads) {
      thread.join();
    }
    for (const auto& each : hashes) {
      EXPECT_EQ(each, expected) << solver;
    }
  }
}

TEST(CrowdTest, AClearedEngineBeginsAgainAsAFreshOne) {
  const auto run = [](World& world) {
    const Row footbot = world.addFootbot(flatPose(2.0, 2.0));
    world.addPrey(0.06, 0.1, 0.3, 2.2, 2.02);
    world.drive(footbot, 0.2, 0.3);
    world.step(30);
    return stateHash(world.space);
  };
  World fresh;
  const std::uint64_t expected = run(fresh);
  World used;
  used.addFootbot(flatPose(1.0, 2.0));
  used.addPrey(0.06, 0.1, 0.3, 1.2, 2.02);
  used.step(20);
  used.engine.clear();
  used.space.entities.clear();
  used.space.actuation.clear();
  used.space.tick = 0;
  EXPECT_EQ(run(used), expected);
}

TEST(CrowdTest, AMirrorPushesWhatItMeets) {
  World world;
  const Row prey = world.addPrey(0.06, 0.1, 0.3, 2.0, 2.0);
  const Row mirror = world.add(robotModel("footbot"), flatPose(1.5, 2.0), Role::kMirror);
  for (int i = 1; i <= 60; ++i) {
    world.step();
    // another engine moves the entity in the same phase
    world.pose(mirror).position.x() = 1.5 + 0.01 * i;
    world.twist(mirror).linear.x() = 0.1;
  }
  world.step();
  EXPECT_NEAR(world.pose(prey).position.x(), world.pose(mirror).position.x() + 0.11 + 0.06, 0.015);
  EXPECT_NEAR(world.pose(prey).position.y(), 2.0, 0.01);
  EXPECT_EQ(world.pose(mirror).position.z(), 0.0);
  EXPECT_EQ(world.twist(mirror).linear.x(), 0.1);  // this engine does not move it
}

TEST(CrowdTest, MirrorsPutUponRobotsPushThemOutSlowly) {
  World world;
  std::vector<Row> rows;
  for (int i = 0; i < 5; ++i) {
    rows.push_back(world.addFootbot(flatPose(2.0 + 0.2 * i, 2.0, 0.5 * i)));
  }
  world.add(cylindricPreyModel(0.2, 0.3), flatPose(2.4, 2.05), Role::kMirror);
  for (int tick = 0; tick < 100; ++tick) {
    world.step();
    for (const Row row : rows) {
      ASSERT_LT(world.twist(row).linear.norm(), 1.5) << "tick " << tick;
      ASSERT_LT(world.twist(row).angular.norm(), 20.0) << "tick " << tick;
    }
  }
  EXPECT_GT((world.pose(rows[2]).position - Vector3d(2.4, 2.05, 0.0)).head<2>().norm(), 0.2 + 0.085 - 0.01);
}

TEST(CrowdTest, CommandStepsDoNotMakeARobotFall) {
  World world;
  const Row footbot = world.addFootbot(flatPose(2.0, 2.0));
  for (int tick = 0; tick < 60; ++tick) {
    world.drive(footbot, tick % 4 < 2 ? 0.3 : -0.3);
    world.step();
    ASSERT_LT(tiltOf(world.pose(footbot)), 0.05) << "tick " << tick;
    ASSERT_LT(world.twist(footbot).linear.norm(), 0.31) << "tick " << tick;
  }
}

}  // namespace
}  // namespace swarmanoid::dynamics3d
