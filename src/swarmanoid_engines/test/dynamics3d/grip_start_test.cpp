// A grip that closes at once holds as much as a later one: a robot that only stands there puts no load on it.
#include <gtest/gtest.h>

#include <string>

#include "world.hpp"

namespace swarmanoid::dynamics3d {
namespace {

struct Start {
  int tick;           // ms
  int wait;           // ticks, until the gripper is closed
  bool has_turret;    // device
  bool is_handed_on;  // removed from the engine and added again when it is closed
};

/// A footbot that stands before a prey and closes its gripper, in steps of 10 ms.
struct GrippingPair {
  GrippingPair(const Start& start, double mass, double strength)
      : tick(start.tick),
        world({{"subclock", std::to_string(start.tick / 10)},
               {"friction", "0.5"},
               {"grip_strength", std::to_string(strength)}}) {
    world.space.clocktick = std::chrono::milliseconds(tick);
    footbot = start.has_turret ? world.addTurret(flatPose(2.0, 2.0)) : world.addFootbot(flatPose(2.0, 2.0));
    prey = world.addPrey(0.1, 0.12, mass, 2.217, 2.0);
    world.step(start.wait);
    world.setGripper(footbot, true);
    world.step();
    EXPECT_EQ(world.gripped(footbot), prey);
    if (start.is_handed_on) {
      world.engine.remove(world.space, footbot);
      world.engine.remove(world.space, prey);
      test::carryOut(world.space);
      world.engine.add(world.space, prey, Role::kMove);
      test::carryOut(world.space);
      world.engine.add(world.space, footbot, Role::kMove);
    }
  }
  void run(double seconds) { world.step(static_cast<int>(seconds * 1e3) / tick); }
  bool holds() const { return world.gripped(footbot) == prey; }

  int tick;  // ms
  World world;
  Row footbot = kNoRow;
  Row prey = kNoRow;
};

class GripStartTest : public testing::TestWithParam<Start> {};

TEST_P(GripStartTest, WhoOnlyStandsPullsAtNothing) {
  for (const double mass : {0.3, 1.7}) {
    GrippingPair pair(GetParam(), mass, 0.05);
    pair.run(2.0);
    EXPECT_TRUE(pair.holds()) << mass << " kg";
  }
}

TEST_P(GripStartTest, AGripTearsAtItsStrength) {
  constexpr double kStrength = 9.3;  // N
  for (const double share : {0.95, 1.05}) {
    GrippingPair pair(GetParam(), share * kStrength / (0.5 * kGravity), kStrength);
    pair.world.drive(pair.footbot, -0.004);
    pair.run(3.0);
    EXPECT_EQ(pair.holds(), share < 1.0) << share << " of its strength";
  }
}

INSTANTIATE_TEST_SUITE_P(Starts, GripStartTest,
                         testing::Values(Start{10, 0, false, false}, Start{10, 3, false, false},
                                         Start{10, 200, false, false}, Start{10, 0, true, false},
                                         Start{10, 0, false, true}, Start{10, 0, true, true},
                                         Start{100, 0, false, false}, Start{100, 20, false, false},
                                         Start{100, 0, true, false}, Start{100, 20, true, true}));

}  // namespace
}  // namespace swarmanoid::dynamics3d
