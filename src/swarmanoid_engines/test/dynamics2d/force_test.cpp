// Pushing force of a footbot, and the slip of its treels.
#include <gtest/gtest.h>

#include "world.hpp"

namespace swarmanoid::dynamics2d {
namespace {

constexpr double kFootbotMass = 1.8;
constexpr double kTreelFriction = 0.9;
constexpr double kGroundFriction = 0.4;
/// Largest mass of a block that a footbot can push.
constexpr double kLimit = kTreelFriction * kFootbotMass / kGroundFriction;

class PushTest : public testing::TestWithParam<int> {
 protected:
  /// Way of a block that a footbot pushes for 10 s, after it has reached the block.
  double wayOfBlock(double mass) {
    World world({10.0, 10.0, 2.0}, GetParam());
    const Row footbot = world.addFootbot(flatPose(1.0, 1.0));
    const auto model = blockModel({0.3, 0.3, 0.1}, mass);
    const Row block = world.add(model, flatPose(1.11 + 0.15 + 0.005, 1.0, 0.0, 0.05));
    world.drive(footbot, 0.1);
    world.step(10);
    const double start = world.pose(block).position.x();
    world.step(100);
    return world.pose(block).position.x() - start;
  }
};

TEST_P(PushTest, WhatIsJustLightEnoughIsPushedAtFullSpeed) { EXPECT_NEAR(wayOfBlock(0.95 * kLimit), 1.0, 0.02); }

TEST_P(PushTest, WhatIsJustTooHeavyStays) { EXPECT_LT(wayOfBlock(1.05 * kLimit), 1e-3); }

INSTANTIATE_TEST_SUITE_P(Subclocks, PushTest, testing::Values(1, 4, 10, 50));

/// Way of a robot of another mass, with locked treels, that a footbot pushes for 5 s.
double wayOfStanding(double mass) {
  World world({10.0, 10.0, 2.0}, 10);
  auto model = std::make_shared<EntityModel>(*discModel(0.085, 0.1));
  model->inertia *= mass / model->mass;
  model->mass = mass;
  const Row standing = world.addRobot(model, flatPose(2.0, 1.0, M_PI / 2.0));
  const Row pusher = world.addFootbot(flatPose(2.0 - 0.085 - 0.112, 1.0));
  world.drive(pusher, 0.1);
  world.step(50);
  return world.pose(standing).position.x() - 2.0;
}

TEST(SlipTest, LockedTreelsHoldAgainstLessThanTheirFriction) { EXPECT_LT(wayOfStanding(1.05 * kFootbotMass), 0.01); }

TEST(SlipTest, LockedTreelsSlipWhenPushedHarder) { EXPECT_NEAR(wayOfStanding(0.95 * kFootbotMass), 0.5, 0.02); }

}  // namespace
}  // namespace swarmanoid::dynamics2d
