// The rope of handbots: shot, wound, slack, swung, torn; against the predictions of physics.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "handbot_world.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;

const Vector3d kLauncher = robotModel("handbot")->mount("rope_launcher").position;

/// Shoots the rope, winds the robot up to this height, and waits.
Row hang(HandbotWorld& world, double height) {
  const Row robot = world.addHandbot(flatPose(2.0, 2.0));
  world.rope(robot).shot = true;
  world.step(20);
  world.rope(robot).winding_speed = 0.1;
  while (world.pose(robot).position.z() < height) {
    world.step();
  }
  world.rope(robot).winding_speed = 0.0;
  world.step(300);
  return robot;
}

TEST(RopeTest, IsShotAndHoldsOnTheCeiling) {
  HandbotWorld world;
  const Row robot = world.addHandbot(flatPose(2.0, 2.0));
  world.step(5);
  EXPECT_FALSE(world.space.attachments.isAttached(robot));
  world.rope(robot).shot = true;
  // 2.2 m at 10 m/s: in the third tick
  world.step(2);
  EXPECT_FALSE(world.space.attachments.isAttached(robot));
  world.step();
  EXPECT_EQ(world.held(robot, kRope).held, world.ceiling);
  ASSERT_EQ(world.space.events.size(), 1U);
  EXPECT_EQ(world.space.events[0].kind, Event::Kind::kAttached);
  EXPECT_EQ(world.space.events[0].text, "rope");
  EXPECT_NEAR(world.held(robot, kRope).length, kCeiling - kLauncher.z(), 2e-3);
  const Vector3d anchor = world.pose(world.ceiling).position + world.held(robot, kRope).anchor;
  EXPECT_NEAR(anchor.z(), kCeiling, 1e-9);
  world.rope(robot).shot = false;
  world.step();
  EXPECT_FALSE(world.space.attachments.isAttached(robot));
}

TEST(RopeTest, ComesBackFromWhatIsNotFerromagnetic) {
  HandbotWorld world({}, false);
  const Row robot = world.addHandbot(flatPose(2.0, 2.0));
  world.rope(robot).shot = true;
  world.step(3);
  ASSERT_EQ(world.space.events.size(), 1U);
  EXPECT_EQ(world.space.events[0].kind, Event::Kind::kReleased);
  EXPECT_EQ(world.space.events[0].text, "rope: what it met is not ferromagnetic");
  world.step(50);
  EXPECT_FALSE(world.space.attachments.isAttached(robot));
  EXPECT_TRUE(world.space.events.empty());
}

TEST(RopeTest, TooShortARopeMeetsNothing) {
  World world;
  HandbotWorld under_the_sky;
  const Row robot = under_the_sky.addHandbot(flatPose(8.0, 8.0));
  under_the_sky.rope(robot).shot = true;
  under_the_sky.step(3);
  ASSERT_EQ(under_the_sky.space.events.size(), 1U);
  EXPECT_EQ(under_the_sky.space.events[0].text, "rope: it met nothing");
}

TEST(RopeTest, TensionOfAHangingHandbotIsItsWeight) {
  HandbotWorld world({{"rope_drag", "5"}});  // without drag, the swing that the winding starts would never end
  const Row robot = hang(world, 0.5);
  const double weight = robotModel("handbot")->mass * kGravity;
  EXPECT_GT(world.pose(robot).position.z(), 0.45);
  EXPECT_NEAR(world.held(robot, kRope).force, weight, 0.01 * weight);
  const double before = world.pose(robot).position.z();
  world.step(100);
  EXPECT_NEAR(world.pose(robot).position.z(), before, 2e-3);
}

/// 16 footbots on a square lattice that drive to its middle. @param distance of neighbours in the lattice [m]
void addFootbots(HandbotWorld& world, double distance) {
  for (int i = 0; i < 16; ++i) {
    const Vector3d place(distance * (i % 4 - 1.5), distance * (i / 4 - 1.5), 0.0);
    world.drive(world.addFootbot(flatPose(8.0 + place.x(), 8.0 + place.y(), std::atan2(-place.y(), -place.x()))), 0.15);
  }
}

TEST(RopeTest, CarriesBesideACrowdAsBesideRobotsApart) {
  // a crowd has its own solution in each step, without the handbot
  HandbotWorld apart;
  HandbotWorld pressed;
  addFootbots(apart, 2.0);
  addFootbots(pressed, 0.18);
  const Row robot = hang(apart, 0.5);
  ASSERT_EQ(hang(pressed, 0.5), robot);
  const double weight = robotModel("handbot")->mass * kGravity;
  EXPECT_NEAR(pressed.held(robot, kRope).force, weight, 0.02 * weight);
  EXPECT_NEAR(pressed.held(robot, kRope).force, apart.held(robot, kRope).force, 1e-3);
  EXPECT_LT((pressed.pose(robot).position - apart.pose(robot).position).norm(), 1e-6);
  for (std::size_t i = 0; i < apart.space.joints[robot].size(); ++i) {
    EXPECT_NEAR(pressed.space.joints[robot][i].angle, apart.space.joints[robot][i].angle, 1e-6);
  }
  EXPECT_GT(pressed.engine.solverCounts().large, 100U);
}

TEST(RopeTest, WindsAsFastAsItIsTold) {
  HandbotWorld world;
  const Row robot = hang(world, 0.3);
  const double start = world.pose(robot).position.z();
  const double length = world.held(robot, kRope).length;
  world.rope(robot).winding_speed = 0.2;
  world.step(50);
  EXPECT_NEAR(world.held(robot, kRope).length, length - 1.0, 1e-9);
  EXPECT_NEAR(world.pose(robot).position.z() - start, 1.0, 0.01);
  world.rope(robot).winding_speed = -0.1;
  world.step(50);
  EXPECT_NEAR(world.pose(robot).position.z() - start, 0.5, 0.01);
}

TEST(RopeTest, NeverPushes) {
  HandbotWorld world;
  const Row robot = hang(world, 0.2);
  // unwinding lowers the robot to the ground; then the rope is slack and lets it stand
  world.rope(robot).winding_speed = -0.2;
  world.step(40);
  EXPECT_NEAR(world.pose(robot).position.z(), 0.0, 2e-3);
  EXPECT_NEAR(world.held(robot, kRope).force, 0.0, 1e-3);
  EXPECT_GT(world.held(robot, kRope).length, kCeiling - kLauncher.z() + 0.3);
  EXPECT_LT(tiltOf(world.pose(robot)), 0.01);
}

TEST(RopeTest, SwingsAsACompoundPendulumDoes) {
  HandbotWorld world;
  const Row robot = hang(world, 0.5);
  const EntityModel& model = *robotModel("handbot");
  const double length = world.held(robot, kRope).length;
  // A rope and a stiff robot on it: two angles, of the rope and of the robot, seen along y. For small ones
  // m L2 a'' + m L d b'' + m g L a = 0, m L d a'' + (I + m d2) b'' + m g d b = 0.
  const double m = model.mass;
  const Vector3d arm = model.centre_of_mass - kLauncher;
  const double d = arm.norm();
  const double inertia = model.inertia(1, 1);
  Eigen::Matrix2d masses;
  masses << m * length * length, m * length * d, m * length * d, inertia + m * d * d;
  const Eigen::Matrix2d stiffness = m * kGravity * Eigen::Vector2d(length, d).asDiagonal().toDenseMatrix();
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d> modes(stiffness, masses);
  const double period = 2.0 * M_PI / std::sqrt(modes.eigenvalues()[0]);
  const Eigen::Vector2d mode = modes.eigenvectors().col(0);

  // pushed so that only the slow mode swings, by 2 degrees
  const double amplitude = 0.035 * 2.0 * M_PI / period;
  const double robot_rate = amplitude * mode[1] / mode[0];
  const double at = world.pose(robot).position.x();
  const Vector3d launcher_speed = -amplitude * length * Vector3d::UnitX();
  const Vector3d turning = robot_rate * Vector3d::UnitY();
  const Vector3d launcher = world.pose(robot).orientation * kLauncher;
  Twist& twist = world.twist(robot);
  twist.angular = turning;
  twist.linear = launcher_speed - turning.cross(launcher);
  world.engine.remove(world.space, robot);
  test::carryOut(world.space);
  world.engine.add(world.space, robot, Role::kMove);

  double first = 0.0;
  double last = 0.0;
  int crossings = 0;
  double before = 0.0;
  for (int tick = 1; tick <= 400; ++tick) {
    world.step();
    const double now = world.pose(robot).position.x() - at;
    if (before > 0.0 && now <= 0.0) {
      last = 0.1 * (tick - 1 + before / (before - now));
      first = crossings++ == 0 ? last : first;
    }
    before = now;
  }
  ASSERT_GT(crossings, 5);
  EXPECT_NEAR((last - first) / (crossings - 1), period, 0.01 * period);
}

TEST(RopeTest, IsTornOffAtTheStatedForce) {
  // wound up against a heavy obstacle: the motor gives 60 N
  const double weight = robotModel("handbot")->mass * kGravity;
  HandbotWorld strong({{"rope_strength", std::to_string(1.05 * weight)}});
  const Row holds = hang(strong, 0.3);
  EXPECT_TRUE(strong.space.attachments.isAttached(holds));

  HandbotWorld weak({{"rope_strength", std::to_string(0.95 * weight)}});
  const Row falls = weak.addHandbot(flatPose(2.0, 2.0));
  weak.rope(falls).shot = true;
  weak.step(5);
  weak.rope(falls).winding_speed = 0.01;
  std::string text;
  for (int i = 0; i < 200 && text.empty(); ++i) {
    weak.step();
    text = weak.space.events.empty() ? "" : weak.space.events[0].text;
  }
  EXPECT_EQ(text.rfind("rope: torn off: pulled with more than ", 0), 0U) << text;
  EXPECT_FALSE(weak.space.attachments.isAttached(falls));
  weak.step(50);
  EXPECT_FALSE(weak.space.attachments.isAttached(falls));  // until it is called back
}

}  // namespace
}  // namespace swarmanoid::dynamics3d
