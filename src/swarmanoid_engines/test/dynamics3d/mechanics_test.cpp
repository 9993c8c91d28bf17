// Newton's, Coulomb's and Galilei's laws, for blocks and preys.
#include <gtest/gtest.h>

#include "slope.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "world.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;

/// Slope and block, both tilted by an angle towards a direction, as in an experiment file.
struct BlockSlope : Slope {
  BlockSlope(double angle, double direction, World::Values values) : Slope(std::move(values)) {
    const Eigen::Quaterniond tilt = Eigen::AngleAxisd(direction, Vector3d::UnitZ()) *
                                    Eigen::AngleAxisd(angle, Vector3d::UnitY()) *
                                    Eigen::AngleAxisd(-direction, Vector3d::UnitZ());
    world.addBlock({4.0, 4.0, 0.2}, 0.0, {{5.0, 5.0, 2.0}, tilt});
    putBlock(Vector3d(5.0, 5.0, 2.0) + tilt * Vector3d(0.0, 0.0, 0.1), tilt,
             Eigen::AngleAxisd(direction, Vector3d::UnitZ()) * Vector3d::UnitX());
  }
};

class SlopeTest : public testing::TestWithParam<double> {};

TEST_P(SlopeTest, ABlockSlidesFromTheFrictionAngleOn) {
  expectToSlideFromTheFrictionAngleOn<BlockSlope>(GetParam() * kDegree, 2e-4, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Directions, SlopeTest, testing::Values(0.0, 90.0, 180.0, 30.0, 45.0, -60.0));

TEST(MechanicsTest, ACylinderLiesOnItsSide) {
  // on level ground and on a block, at any heading: the height of its axis is its radius
  constexpr double kRadius = 0.073;  // m
  constexpr double kHeight = 0.21;   // m
  for (const double heading : {0.0, 0.7, 2.9}) {
    World world;
    world.addBlock({1.0, 1.0, 0.3}, 0.0, flatPose(5.0, 5.0, 0.4, 0.15));
    const Eigen::Quaterniond lying = Eigen::AngleAxisd(heading, Vector3d::UnitZ()) *
                                     Eigen::Quaterniond(Eigen::AngleAxisd(0.5 * M_PI, Vector3d::UnitY()));
    const Vector3d half_up = lying * Vector3d(0.0, 0.0, 0.5 * kHeight);  // a prey's origin is in its foot
    const auto prey = cylindricPreyModel(kRadius, kHeight, 0.4);
    const Row on_ground = world.add(prey, {Vector3d(2.0, 2.0, kRadius + 2e-4) - half_up, lying});
    const Row on_block = world.add(prey, {Vector3d(5.0, 5.0, 0.3 + kRadius + 2e-4) - half_up, lying});
    world.step(20);
    EXPECT_NEAR((world.pose(on_ground).position + half_up).z(), kRadius, 2e-5) << heading;
    EXPECT_NEAR((world.pose(on_block).position + half_up).z(), 0.3 + kRadius, 2e-5) << heading;
  }
}

TEST(MechanicsTest, ABlockThatSlidesStopsAfterItsFrictionDistance) {
  for (const double direction : {0.0, 0.5, M_PI / 4.0}) {
    World world({{"friction", "0.4"}});
    const Row block = world.addToSpace(blockModel({0.2, 0.2, 0.1}, 2.0), flatPose(2.0, 2.0, 0.2, 0.05));
    const Vector3d along(std::cos(direction), std::sin(direction), 0.0);
    world.twist(block).linear = 1.5 * along;
    test::carryOut(world.space);
    world.engine.add(world.space, block, Role::kMove);
    world.step(10);
    const Vector3d way = world.pose(block).position - Vector3d(2.0, 2.0, 0.05);
    const double expected = 1.5 * 1.5 / (2.0 * 0.4 * kGravity);
    EXPECT_NEAR(way.dot(along), expected, 0.03 * expected);
    EXPECT_LT((way - way.dot(along) * along).norm(), 0.02 * expected);
    EXPECT_LT(world.twist(block).linear.norm(), 1e-6);
  }
}

TEST(MechanicsTest, AThrownBlockFollowsAParabola) {
  World world({{"ground", "false"}, {"subclock", "50"}});
  const Row block = world.addToSpace(blockModel({0.3, 0.2, 0.1}, 1.0), flatPose(1.0, 1.0, 0.0, 1.0));
  world.twist(block) = {{2.0, 1.0, 4.0}, {1.0, 2.0, 3.0}};
  test::carryOut(world.space);
  world.engine.add(world.space, block, Role::kMove);
  const double step = 0.1 / 50.0;
  for (int i = 1; i <= 10; ++i) {
    world.step();
    const double t = 0.1 * i;
    const Vector3d expected(1.0 + 2.0 * t, 1.0 + t, 1.0 + 4.0 * t - 0.5 * kGravity * t * t);
    // the integrator's own error is known: half a step times the gain in velocity
    const Vector3d error(0.0, 0.0, -0.5 * kGravity * t * step);
    ASSERT_LT((world.pose(block).position - expected - error).norm(), 1e-9);
    ASSERT_LT((world.twist(block).linear - Vector3d(2.0, 1.0, 4.0 - kGravity * t)).norm(), 1e-9);
  }
}

TEST(MechanicsTest, AFreeBodyKeepsItsAngularMomentum) {
  World world({{"ground", "false"}, {"gravity", "0"}, {"subclock", "50"}});
  const auto model = blockModel({0.3, 0.2, 0.1}, 1.0);
  const Row block = world.addToSpace(model, flatPose(1.0, 1.0, 0.0, 1.0));
  world.twist(block).angular = {1.0, 2.0, 3.0};
  test::carryOut(world.space);
  world.engine.add(world.space, block, Role::kMove);
  const auto momentum = [&] {
    const Eigen::Matrix3d axes = world.pose(block).orientation.toRotationMatrix();
    return Vector3d(axes * model->inertia * axes.transpose() * world.twist(block).angular);
  };
  const Vector3d before = momentum();
  world.step(20);
  EXPECT_LT((momentum() - before).norm(), 0.02 * before.norm());
  EXPECT_LT((world.pose(block).position - Vector3d(1.0, 1.0, 1.0)).norm(), 1e-9);
}

/// Two blocks without gravity collide.
struct Collision {
  explicit Collision(const char* restitution)
      : world({{"ground", "false"}, {"gravity", "0"}, {"restitution", restitution}}) {
    for (const double sign : {-1.0, 1.0}) {
      const double mass = sign < 0.0 ? 2.0 : 1.0;
      const Row row = world.addToSpace(blockModel({0.1, 0.1, 0.1}, mass), flatPose(2.0 + 0.2 * sign, 2.0, 0.0, 1.0));
      world.twist(row).linear = {sign < 0.0 ? 1.0 : -0.5, 0.0, 0.0};
      test::carryOut(world.space);
      world.engine.add(world.space, row, Role::kMove);
      (sign < 0.0 ? left : right) = row;
    }
    world.step(5);
  }
  double momentum() const { return 2.0 * world.twist(left).linear.x() + world.twist(right).linear.x(); }
  double energy() const {
    return world.twist(left).linear.squaredNorm() + 0.5 * world.twist(right).linear.squaredNorm();
  }

  World world;
  Row left = kNoRow;
  Row right = kNoRow;
};

TEST(MechanicsTest, AnElasticCollisionKeepsMomentumAndEnergy) {
  const Collision collision("1");
  EXPECT_NEAR(collision.momentum(), 1.5, 1e-4);
  EXPECT_NEAR(collision.energy(), 1.125, 0.01 * 1.125);
  EXPECT_NEAR(collision.world.twist(collision.left).linear.x(), 0.0, 0.01);   // (2 - 1) / 3 - 2 / 3 * 0.5
  EXPECT_NEAR(collision.world.twist(collision.right).linear.x(), 1.5, 0.01);  // 4 / 3 + 0.5 / 3
}

TEST(MechanicsTest, APlasticCollisionKeepsMomentumOnly) {
  const Collision collision("0");
  EXPECT_NEAR(collision.momentum(), 1.5, 1e-4);
  EXPECT_NEAR(collision.world.twist(collision.left).linear.x(), 0.5, 1e-3);
  EXPECT_NEAR(collision.world.twist(collision.right).linear.x(), 0.5, 1e-3);
  const double gap =
      collision.world.pose(collision.right).position.x() - collision.world.pose(collision.left).position.x() - 0.1;
  EXPECT_NEAR(gap, 0.0, 1e-4);
}

TEST(MechanicsTest, ABallOfRestitutionBounces) {
  World world({{"restitution", "0.8"}, {"subclock", "50"}, {"friction", "0"}});
  auto ball = std::make_shared<EntityModel>();
  ball->type = "ball";
  ball->is_movable = true;
  ball->shapes.push_back({CollisionShape::Kind::kSphere, Vector3d::Constant(0.1), Vector3d::Zero()});
  ball->measureShapes();
  ball->addMass({1.0, Vector3d::Zero(), 0.004 * Eigen::Matrix3d::Identity()});
  const Row row = world.add(ball, flatPose(2.0, 2.0, 0.0, 1.1));
  double highest = 0.0;
  bool has_bounced = false;
  for (int i = 0; i < 12; ++i) {
    world.step();
    has_bounced = has_bounced || world.twist(row).linear.z() > 0.0;
    highest = has_bounced ? std::max(highest, world.pose(row).position.z()) : 0.0;
  }
  EXPECT_NEAR(highest - 0.1, 0.64, 0.03);
}

TEST(MechanicsTest, WhatStandsStaysWhereItIs) {
  World world;
  const Row prey = world.addPrey(0.06, 0.1, 0.3, 1.0, 1.0);
  const Row block = world.addBlock({0.2, 0.3, 0.1}, 2.0, flatPose(2.0, 2.0, 0.4, 0.05));
  const Row upper = world.addBlock({0.1, 0.1, 0.1}, 0.5, flatPose(2.0, 2.0, 0.7, 0.15));
  const Row on_top = world.add(cylindricPreyModel(0.04, 0.1), flatPose(2.0, 2.0, 0.0, 0.2));
  const Row handbot = world.add(robotModel("handbot"), flatPose(4.0, 4.0));
  std::vector<Pose> before;
  for (const Row row : {prey, block, upper, on_top, handbot}) {
    before.push_back(world.pose(row));
  }
  world.step(100);
  std::size_t i = 0;
  for (const Row row : {prey, block, upper, on_top, handbot}) {
    EXPECT_LT((world.pose(row).position - before[i].position).norm(), 5e-5) << "entity " << i;
    EXPECT_LT(world.pose(row).orientation.angularDistance(before[i].orientation), 1e-3) << "entity " << i;
    EXPECT_LT(world.twist(row).linear.norm(), 1e-4) << "entity " << i;
    ++i;
  }
}

TEST(MechanicsTest, ATallBlockTopplesOnASlopeThatHoldsALowOne) {
  const auto falls = [](double height) {
    World world;
    const Eigen::Quaterniond tilt(Eigen::AngleAxisd(20.0 * kDegree, Vector3d::UnitY()));
    world.addBlock({2.0, 2.0, 0.2}, 0.0, {{5.0, 5.0, 1.0}, tilt});
    const Vector3d place = Vector3d(5.0, 5.0, 1.0) + tilt * Vector3d(0.0, 0.0, 0.1 + height / 2.0);
    const Row block = world.addBlock({0.1, 0.1, height}, 1.0, {place, tilt});
    world.step(10);
    return world.pose(block).orientation.angularDistance(tilt) > 0.5;
  };
  EXPECT_FALSE(falls(0.2));  // the vertical through its centre goes through its base: tan 20 < 0.1 / 0.2
  EXPECT_TRUE(falls(0.4));
}

}  // namespace
}  // namespace swarmanoid::dynamics3d
