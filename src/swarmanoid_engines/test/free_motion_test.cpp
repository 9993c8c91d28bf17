// Bodies that move freely, or with their block, reach the poses that they would reach one after another, whatever the
// size of blocks and the order in which they move.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "world.hpp"

namespace swarmanoid::kinematics2d {
namespace {

struct Scene {
  double side;  // m, of the square that holds all bodies
  int subclock;
  std::size_t block;     // number of bodies
  double fastest = 0.3;  // robot [m/s]; from 0.425 on footbots move in pieces
  bool has_grips = true;
};

/// Runs the ranges in reverse order, as if the last thread always came first.
class LastFirst : public Parallel {
 public:
  std::size_t threads() const override { return 1000; }

 protected:
  void runRanges(std::size_t count, std::size_t, const void* work, Call call) const override {
    runEach(count, work, call);
  }
  void runEach(std::size_t count, const void* work, Call call) const override {
    for (std::size_t k = count; k > 0; --k) {
      call(work, k - 1, k);
    }
  }
};

/// Footbots, some with turrets, among preys, handbots, a wall and wandering mirrors; all act at random.
class Hustle {
 public:
  explicit Hustle(const Scene& scene)
      : world({20.0, 20.0, 1.0}, scene.subclock), fastest(scene.fastest), has_grips(scene.has_grips) {
    world.addBlock({0.1, scene.side, 0.5}, {2.0 + scene.side, 2.0 + 0.5 * scene.side, 0.25});
    for (int line = 0; line < kPerSide; ++line) {
      for (int column = 0; column < kPerSide; ++column) {
        const double distance = scene.side / kPerSide;
        addOne(line * kPerSide + column, 2.0 + distance * column, 2.0 + distance * line);
      }
    }
  }

  void step() {
    for (const Row row : robots) {
      if (random() % 8 == 0) {
        world.drive(row, uniform(-0.05, fastest), random() % 4 == 0 ? 0.0 : uniform(-2.0, 2.0));
      }
      if (has_grips && random() % 16 == 0) {
        world.setGripper(row, random() % 4 != 0);
      }
    }
    for (const Row row : turrets) {
      if (random() % 16 == 0) {
        world.turret(row).letTurn();
      } else if (random() % 8 == 0) {
        world.turret(row).turnAt(uniform(-2.0, 2.0));
      }
    }
    for (const Row row : mirrors) {
      world.pose(row).position.head<2>() += Eigen::Vector2d(uniform(-0.01, 0.01), uniform(-0.01, 0.01));
    }
    world.step();
    grips += static_cast<int>(world.space.events.size());
  }

  World world;
  double fastest;
  bool has_grips;
  std::vector<Row> robots, turrets, mirrors;
  int grips = 0;

 private:
  static constexpr int kPerSide = 9;

  void addOne(int number, double x, double y) {
    if (number % 7 == 3) {
      world.addPrey(0.05, 0.1, x, y);
    } else if (number % 13 == 6) {
      world.add(robotModel("handbot"), flatPose(x, y));  // several may grip it
    } else if (number % 11 == 5) {
      mirrors.push_back(world.add(cylindricPreyModel(0.05, 0.1), flatPose(x, y), Role::kMirror));
    } else if (number % 5 == 1) {
      turrets.push_back(world.addTurret(flatPose(x, y, uniform(-3.0, 3.0))));
      robots.push_back(turrets.back());
    } else {
      robots.push_back(world.addFootbot(flatPose(x, y, uniform(-3.0, 3.0))));
    }
  }

  double uniform(double low, double high) { return low + (high - low) * static_cast<double>(random()) / 4294967296.0; }

  std::mt19937 random{5};
};

class FreeMotionScenesTest : public testing::TestWithParam<Scene> {};

TEST_P(FreeMotionScenesTest, AllComeWhereTheyWouldHaveComeInTurn) {
  const LastFirst last_first;
  Hustle first(GetParam());
  first.world.engine.setLeastBlock(GetParam().block);
  first.world.engine.prepare({nullptr, &last_first});
  Hustle in_turn(GetParam());
  in_turn.world.engine.setLeastBlock(0);
  for (int tick = 0; tick < 400; ++tick) {
    first.step();
    in_turn.step();
    for (const Row row : first.world.space.entities.order) {
      const Space& a = first.world.space;
      const Space& b = in_turn.world.space;
      ASSERT_EQ(a.entities.pose[row].position, b.entities.pose[row].position) << "tick " << tick;
      ASSERT_EQ(a.entities.pose[row].orientation.coeffs(), b.entities.pose[row].orientation.coeffs()) << tick;
      ASSERT_EQ(a.entities.twist[row].linear, b.entities.twist[row].linear) << "tick " << tick;
      ASSERT_EQ(a.entities.twist[row].angular, b.entities.twist[row].angular) << "tick " << tick;
      ASSERT_EQ(a.wheel_turns[row].left, b.wheel_turns[row].left) << "tick " << tick;
      ASSERT_EQ(a.structure.grippedBy(row), b.structure.grippedBy(row)) << "tick " << tick;
    }
  }
  // grips and releases happened, so bodies have met
  if (GetParam().has_grips) {
    EXPECT_GT(first.grips, 20);
  } else {
    EXPECT_EQ(0, first.grips);
  }
}

/// Members of a group go along with it, even if the first of its grippers has no drive.
TEST(FreeMotionTest, AGroupWhoseFirstGripperHasNoDriveGoesTheMeanOfAllWays) {
  World world;
  auto without_wheels = std::make_shared<EntityModel>(*footbotModel());
  without_wheels->type = "holder";
  without_wheels->wheels.reset();
  constexpr double kApart = 0.265;  // m: the radius of a handbot's strip, a footbot's tip, 1 cm
  const Row holder = world.addRobot(without_wheels, flatPose(2.0 - kApart, 2.0));
  const Row footbot = world.addFootbot(flatPose(2.0 + kApart, 2.0, M_PI));
  const Row handbot = world.add(robotModel("handbot"), flatPose(2.0, 2.0));
  world.setGripper(holder, true);
  world.setGripper(footbot, true);
  world.step();
  ASSERT_EQ(world.space.structure.grippersOf(handbot).size(), 2U);
  world.drive(footbot, -0.1);
  world.step(10);
  EXPECT_NEAR(world.pose(handbot).position.x(), 2.05, 1e-9);
  EXPECT_NEAR(world.pose(holder).position.x(), 2.05 - kApart, 1e-9);
  EXPECT_NEAR(world.pose(footbot).position.x(), 2.05 + kApart, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(, FreeMotionScenesTest,
                         testing::Values(Scene{2.7, 1, 512}, Scene{2.7, 3, 7}, Scene{4.5, 1, 23}, Scene{4.5, 1, 1},
                                         Scene{9.0, 2, 11}, Scene{2.7, 1, 21, 0.3, false},
                                         Scene{4.5, 1, 19, 0.3, false}, Scene{4.5, 1, 20, 0.9},
                                         Scene{4.5, 1, 20, 1.3, false}, Scene{4.5, 2, 23, 1.7, false}));

}  // namespace
}  // namespace swarmanoid::kinematics2d
