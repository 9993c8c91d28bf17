// Long runs stay stable: crowds that push, grip and tear, with a mirror that moves through them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "world.hpp"

namespace swarmanoid::dynamics2d {
namespace {

using Eigen::Vector3d;

constexpr double kSide = 1.4;  // m

/// Eight footbots, two preys and a mirror in a tight box.
struct Crowd {
  Crowd() {
    for (const double at : {0.0, kSide}) {
      world.addBlock({0.02, kSide, 0.5}, {at, kSide / 2.0, 0.25});
      world.addBlock({kSide, 0.02, 0.5}, {kSide / 2.0, at, 0.25});
    }
    for (int i = 0; i < 8; ++i) {
      footbots.push_back(world.addFootbot(flatPose(0.2 + 0.33 * (i % 4), 0.2 + 0.33 * (i / 4), 0.8 * i)));
    }
    bodies = footbots;
    bodies.push_back(world.addPrey(0.1, 0.1, 0.3, 1.0));
    bodies.push_back(world.addPrey(0.06, 0.1, 0.8, 1.0, 5.0));
    mirror = world.add(cylindricPreyModel(0.05, 0.1), flatPose(1.1, 1.1), Role::kMirror);
  }

  /// Runs one tick; at random times each robot gets a new command, which jumps to another extreme.
  void tick() {
    for (const Row row : footbots) {
      if (random() % 16 == 0) {
        world.drive(row, random() % 2 == 0 ? 0.3 : -0.3, (static_cast<double>(random() % 3) - 1.0) * 2.0);
        world.setGripper(row, random() % 2 == 0);
      }
    }
    if (random() % 200 == 0) {
      world.pose(mirror).position.head<2>() = Eigen::Vector2d(0.1 + 1e-3 * static_cast<double>(random() % 1200),
                                                              0.1 + 1e-3 * static_cast<double>(random() % 1200));
    }
    world.step();
  }

  World world{{kSide, kSide, 1.0}, 4, "z", 0.0, {{"grip_strength", "15"}}};
  std::vector<Row> footbots;
  std::vector<Row> bodies;  // all bodies that the engine moves
  Row mirror = kNoRow;
  std::mt19937 random{3};
};

TEST(CrowdTest, StaysInItsBoxAtBoundedSpeeds) {
  const int ticks = std::getenv("SWARMANOID_LONG_TESTS") != nullptr ? 1'000'000 : 10'000;
  Crowd crowd;
  double fastest = 0.0;
  int grips = 0;
  int torn = 0;
  for (int i = 0; i < ticks; ++i) {
    crowd.tick();
    for (const Row row : crowd.bodies) {
      const Vector3d& p = crowd.world.pose(row).position;
      ASSERT_TRUE(p.x() > 0.0 && p.x() < kSide && p.y() > 0.0 && p.y() < kSide)
          << "tick " << i << ": " << p.transpose();
      fastest = std::max(fastest, crowd.world.twist(row).linear.norm());
    }
    for (const Event& event : crowd.world.space.events) {
      grips += event.kind == Event::Kind::kAttached ? 1 : 0;
      torn += event.text == "torn off: pulled with more than 15 N" ? 1 : 0;
    }
  }
  EXPECT_LT(fastest, 1.0) << "one that drives and turns swings what it holds with 0.3 m/s + 2 rad/s * 0.21 m";
  EXPECT_GT(grips, ticks / 200);
  EXPECT_GT(torn, ticks / 2000);
}

TEST(CrowdTest, IsTheSameToTheBitEachTime) {
  Crowd first;
  Crowd second;
  for (int i = 0; i < 1000; ++i) {
    first.tick();
    second.tick();
  }
  for (const Row row : first.bodies) {
    EXPECT_EQ(first.world.pose(row).position, second.world.pose(row).position);
    EXPECT_EQ(first.world.pose(row).orientation.coeffs(), second.world.pose(row).orientation.coeffs());
  }
}

}  // namespace
}  // namespace swarmanoid::dynamics2d
