// Long runs stay stable: a few robots that push, grip and tear in a box with a mirror placed onto them, and a flying
// one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <random>
#include <vector>

#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "world.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;

constexpr double kSide = 0.9;   // m
constexpr double kWalls = 1.0;  // m high

/// Four footbots, two preys, a mirror among them and an eyebot above, in a box that leaves them little room.
class Box {
 public:
  Box() {
    for (const double at : {-0.05, kSide + 0.05}) {
      world.addBlock({0.1, kSide + 0.2, kWalls}, 0.0, flatPose(at, kSide / 2.0, 0.0, kWalls / 2.0));
      world.addBlock({kSide, 0.1, kWalls}, 0.0, flatPose(kSide / 2.0, at, 0.0, kWalls / 2.0));
    }
    for (int i = 0; i < 4; ++i) {
      footbots.push_back(world.addFootbot(flatPose(0.2 + 0.45 * (i % 2), 0.2 + 0.45 * (i / 2), 0.8 * i)));
    }
    bodies = footbots;
    bodies.push_back(world.addPrey(0.06, 0.1, 0.3, 0.43, 0.43));
    bodies.push_back(world.addPrey(0.06, 0.1, 0.8, 0.43, 0.7));
    eyebot = world.addEyebot(flatPose(0.45, 0.45, 0.0, 0.6));
    bodies.push_back(eyebot);
    mirror = world.add(cylindricPreyModel(0.05, 0.1), flatPose(0.8, 0.1), Role::kMirror);
  }

  /// Runs one tick; at random times each robot gets a new command, which jumps to another extreme.
  void tick() {
    for (const Row row : footbots) {
      if (random_() % 16 == 0) {
        world.drive(row, random_() % 2 == 0 ? 0.3 : -0.3, (static_cast<double>(random_() % 3) - 1.0) * 2.0);
        world.setGripper(row, random_() % 2 == 0);
      }
      standUp(row);
    }
    if (random_() % 10 == 0) {
      world.flight(eyebot).linear.head<2>() = Eigen::Vector2d(between(-0.5, 0.5), between(-0.5, 0.5));
    }
    world.flight(eyebot).linear.z() = world.pose(eyebot).position.z() < 0.4 ? 0.2 : -0.2;
    if (random_() % 200 == 0) {
      world.pose(mirror).position = Vector3d(between(0.1, kSide - 0.1), between(0.1, kSide - 0.1), between(0.0, 0.1));
    }
    world.step();
  }

  World world{{{"grip_strength", "8"}}};
  std::vector<Row> footbots;
  std::vector<Row> bodies;  // all bodies that the engine moves
  Row eyebot = kNoRow;
  Row mirror = kNoRow;
  int falls = 0;

 private:
  double between(double low, double high) { return low + (high - low) * static_cast<double>(random_()) / 4294967295.0; }

  /// A fallen robot would lie for the rest of the run; it is placed at a free spot, if there is one.
  void standUp(Row row) {
    constexpr double kFallen = 0.5;  // rad
    if (tiltOf(world.pose(row)) < kFallen || random_() % 50 != 0) {
      return;
    }
    const Pose pose = flatPose(between(0.13, kSide - 0.13), between(0.13, kSide - 0.13), between(-M_PI, M_PI));
    if (world.engine.overlap(*robotModel("footbot"), pose, row) != kNoRow) {
      return;
    }
    ++falls;
    world.place(row, pose);
  }

  std::mt19937 random_{3};
};

/// An entity's origin is in its underside; after a fall it may touch a wall.
bool isInside(const Vector3d& p) {
  constexpr double kSunk = 5e-3;  // m
  return p.head<2>().minCoeff() > -kSunk && p.head<2>().maxCoeff() < kSide + kSunk && p.z() > -kSunk && p.z() < kWalls;
}

TEST(EnduranceTest, EverybodyStaysInTheBoxAtBoundedSpeeds) {
  const int ticks = std::getenv("SWARMANOID_LONG_TESTS") != nullptr ? 1'000'000 : 2'000;
  Box box;
  double fastest = 0.0;
  double fastest_turn = 0.0;
  int grips = 0;
  int torn = 0;
  for (int i = 0; i < ticks; ++i) {
    box.tick();
    for (const Row row : box.bodies) {
      const Vector3d& p = box.world.pose(row).position;
      ASSERT_TRUE(isInside(p)) << "entity " << toIndex(row) << ", tick " << i << ": " << p.transpose();
      fastest = std::max(fastest, box.world.twist(row).linear.norm());
      fastest_turn = std::max(fastest_turn, box.world.twist(row).angular.norm());
    }
    for (const Event& event : box.world.space.events) {
      grips += event.kind == Event::Kind::kAttached ? 1 : 0;
      torn += event.kind == Event::Kind::kReleased && !event.text.empty() ? 1 : 0;
    }
  }
  const Dynamics3d::SolverCounts& counts = box.world.engine.solverCounts();
  std::cout << "fastest " << fastest << " m/s and " << fastest_turn << " rad/s; " << grips << " grips, " << torn
            << " torn; " << box.falls << " falls; " << counts.steps << " steps, " << counts.redone << " redone, "
            << counts.iterative << " by the iterative solver\n";
  EXPECT_LT(fastest, 2.0) << "eyebots fly with 0.7 m/s, and who falls over falls by some 0.1 m";
  EXPECT_LT(fastest_turn, 20.0);
  EXPECT_GT(grips, ticks / 200);
  EXPECT_GT(torn, ticks / 2000);
}

TEST(EnduranceTest, IsTheSameToTheBitEachTime) {
  Box first;
  Box second;
  for (int i = 0; i < 500; ++i) {
    first.tick();
    second.tick();
    ASSERT_EQ(stateHash(first.world.space), stateHash(second.world.space)) << "tick " << i;
  }
}

}  // namespace
}  // namespace swarmanoid::dynamics3d
