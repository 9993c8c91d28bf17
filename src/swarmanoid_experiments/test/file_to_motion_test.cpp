// From the text of an experiment file to a motion in metres: parser, URDF, controller, wheels and engine together.
// Properties of the engine alone are tested in swarmanoid_engines/test/motion_test.cpp.
#include <gtest/gtest.h>

#include <cmath>

#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

constexpr double kWheelRadius = 0.029;
constexpr double kSeparation = 0.14;

World lineWorld(double left, double right, int subclock) {
  World world;
  world.entities = footbot("fb", 2, 3, 30);
  world.members = member("fb");
  world.drive = "<left>" + std::to_string(left) + "</left><right>" + std::to_string(right) + "</right>";
  world.engine_parameters = "<subclock>" + std::to_string(subclock) + "</subclock>";
  return world;
}

class SubclockTest : public testing::TestWithParam<int> {};

TEST_P(SubclockTest, TenSecondsAtATenthMetrePerSecondAreOneMetre) {
  // std::to_string keeps six digits, so the speed is the one in the text
  const double wheel = std::stod(std::to_string(0.1 / kWheelRadius));
  auto simulation = lineWorld(wheel, wheel, GetParam()).make();
  simulation->start();
  while (!simulation->isFinished()) {
    simulation->tick();
  }
  const Eigen::Vector2d way = poseOf(*simulation, "fb").position.head<2>() - Eigen::Vector2d(2, 3);
  const double expected = wheel * kWheelRadius * 10.0;
  EXPECT_NEAR(expected, 1.0, 1e-6);
  EXPECT_NEAR(way.norm(), expected, 1e-9);
  EXPECT_NEAR(std::atan2(way.y(), way.x()), M_PI / 6, 1e-9);
}

TEST_P(SubclockTest, AnArcEndsWhereGeometrySays) {
  auto simulation = lineWorld(2.0, 5.0, GetParam()).make();
  simulation->start();
  while (!simulation->isFinished()) {
    simulation->tick();
  }
  const double speed = 3.5 * kWheelRadius;
  const double turn_rate = 3.0 * kWheelRadius / kSeparation;
  const double radius = speed / turn_rate;
  const double start = M_PI / 6;
  const double end = start + turn_rate * 10.0;
  const Eigen::Vector2d expected(2.0 + radius * (std::sin(end) - std::sin(start)),
                                 3.0 - radius * (std::cos(end) - std::cos(start)));
  EXPECT_NEAR((poseOf(*simulation, "fb").position.head<2>() - expected).norm(), 0.0, 1e-9);
  EXPECT_NEAR(std::remainder(headingOf(*simulation, "fb") - end, 2 * M_PI), 0.0, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Subclocks, SubclockTest, testing::Values(1, 2, 5, 10, 50));

TEST(MotionTest, TwistIsTheVelocityInTheWorld) {
  auto simulation = lineWorld(3.0, 3.0, 4).make();
  simulation->start();
  simulation->tick();
  const Entities& entities = simulation->space().entities;
  const Twist& twist = entities.twist[entities.find("fb")];
  EXPECT_NEAR((twist.linear - 3.0 * kWheelRadius * Eigen::Vector3d(std::sqrt(0.75), 0.5, 0)).norm(), 0.0, 1e-9);
  EXPECT_EQ(twist.angular.norm(), 0.0);
}

TEST(MotionTest, WheelsAreNoFasterThanTheirMotors) {
  auto simulation = lineWorld(1000.0, 1000.0, 1).make();
  simulation->start();
  simulation->tick();
  EXPECT_NEAR((poseOf(*simulation, "fb").position - Eigen::Vector3d(2, 3, 0)).norm(), 0.03, 1e-9);
}

TEST(MotionTest, AWallIsNotEnteredAndCanBeLeft) {
  World world;
  world.entities = footbot("fb", 2, 3, 0) +
                   "<block id=\"wall\"><position>2.3,3,0.25</position><orientation>0,0,0</orientation>"
                   "<size>0.1,2,0.5</size></block>";
  world.members = member("fb") + member("wall");
  world.drive = "<left>5</left><right>5</right>";
  auto simulation = world.make();
  simulation->start();
  while (!simulation->isFinished()) {
    simulation->tick();
  }
  // the gripper's tip is 0.11 m ahead of the centre, the wall's face at x = 2.25; one step is 0.0145 m
  const double x = poseOf(*simulation, "fb").position.x();
  EXPECT_LE(x, 2.25 - 0.11 + 1e-9);
  EXPECT_GT(x, 2.25 - 0.11 - 5 * kWheelRadius * 0.1 - 1e-9);
}

TEST(MotionTest, ARobotPassesUnderATable) {
  World world;
  world.entities = footbot("fb", 2, 3, 0) +
                   "<block id=\"table\"><position>2.5,3,0.5</position><orientation>0,0,0</orientation>"
                   "<size>0.3,2,0.1</size></block>";
  world.members = member("fb") + member("table");
  world.drive = "<left>5</left><right>5</right>";
  auto simulation = world.make();
  simulation->start();
  while (!simulation->isFinished()) {
    simulation->tick();
  }
  EXPECT_NEAR(poseOf(*simulation, "fb").position.x(), 2 + 5 * kWheelRadius * 10, 1e-9);
}

TEST(GripTest, APreyIsCarriedWithoutDriftAndLetGo) {
  World world;
  world.ticks = 2000;
  world.entities = footbot("fb", 5, 5, 90) +
                   "<cylindric_prey id=\"prey\"><position>5,5.171,0</position><orientation>0,0,0</orientation>"
                   "<radius>0.06</radius><height>0.1</height></cylindric_prey>";
  world.members = member("fb") + member("prey");
  world.drive = "<left>2</left><right>3</right><close_at>0</close_at><open_at>1500</open_at>";
  auto simulation = world.make();
  const Space& space = simulation->space();
  const Row robot = space.entities.find("fb");
  const Row prey = space.entities.find("prey");
  const auto relative = [&] {
    const Pose& carrier = poseOf(*simulation, "fb");
    return Eigen::Vector3d(carrier.orientation.conjugate() * (poseOf(*simulation, "prey").position - carrier.position));
  };
  simulation->start();
  simulation->tick();
  ASSERT_EQ(space.structure.grippedBy(robot), prey);
  ASSERT_EQ(space.events.size(), 1U);
  EXPECT_EQ(space.events[0].kind, Event::Kind::kAttached);
  EXPECT_EQ(space.structure.root(robot), prey);
  const Eigen::Vector3d at_grip = relative();
  for (int i = 0; i < 1400; ++i) {
    simulation->tick();
  }
  EXPECT_NEAR((relative() - at_grip).norm(), 0.0, 1e-12);
  for (int i = 0; i < 200; ++i) {
    simulation->tick();
  }
  EXPECT_EQ(space.structure.grippedBy(robot), kNoRow);
  const Eigen::Vector3d left_at = poseOf(*simulation, "prey").position;
  for (int i = 0; i < 100; ++i) {
    simulation->tick();
  }
  EXPECT_EQ(poseOf(*simulation, "prey").position, left_at);
}

TEST(GripTest, APreyThatIsOutOfReachIsNotGripped) {
  World world;
  world.entities = footbot("fb", 5, 5, 90) +
                   "<cylindric_prey id=\"prey\"><position>5,5.195,0</position><orientation>0,0,0</orientation>"
                   "<radius>0.06</radius><height>0.1</height></cylindric_prey>";
  world.members = member("fb") + member("prey");
  world.drive = "<left>0</left><right>0</right><close_at>0</close_at>";
  auto simulation = world.make();
  simulation->start();
  simulation->tick();
  EXPECT_EQ(simulation->space().structure.grippedBy(simulation->space().entities.find("fb")), kNoRow);
}

}  // namespace
}  // namespace swarmanoid::test
