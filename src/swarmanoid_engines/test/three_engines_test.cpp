// The same scenes in all engines that have the same laws: along a wall, pressed to a wall, pushed off the middle.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>

#include "dynamics2d/dynamics2d.hpp"
#include "dynamics3d/world.hpp"
#include "kinematics2d/kinematics2d.hpp"
#include "planar_world.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "turned_frame.hpp"

namespace swarmanoid {
namespace {

constexpr double kDegree = M_PI / 180.0;
constexpr double kAgree = 0.03;

dynamics3d::World dynamics3dWorld(double friction, const std::string& subclock) {
  return dynamics3d::World({{"friction", std::to_string(friction)}, {"subclock", subclock}});
}
/// Loads rest on their corners, as in dynamics3d.
PlanarWorld<dynamics2d::Dynamics2d> dynamics2dWorld(double friction, const std::string& subclock) {
  const std::string value = std::to_string(friction);
  return PlanarWorld<dynamics2d::Dynamics2d>(
      {10.0, 10.0, 2.0}, std::stoi(subclock), "z", 0.0,
      {{"ground_friction", value}, {"contact_friction", value}, {"support", "edge"}});
}

struct Case {
  double friction;
  double degrees;  // heading, from the wall's normal
  double turn;     // of the world [rad]
  std::string subclock;
};

void PrintTo(const Case& values, std::ostream* out) {
  *out << "friction " << values.friction << ", " << values.degrees << " degrees, " << values.subclock << " steps";
}

Row addFootbot(dynamics3d::World& world, const Pose& pose) { return world.addFootbot(pose); }
template <class Engine>
Row addFootbot(PlanarWorld<Engine>& world, const Pose& pose) {
  return world.template addRobot<>(robotModel("footbot"), pose);
}

class WallTest : public testing::TestWithParam<Case> {
 protected:
  template <class World>
  static double speedAlong(World world) {
    const Case& values = GetParam();
    const TurnedFrame turned(values.turn);
    world.add(blockModel({0.1, 8.0, 0.5}), turned.at(0.05, 0.0, 0.0, 0.25));
    const Row footbot = addFootbot(world, turned.at(-0.12, -1.0, values.degrees * kDegree));
    world.drive(footbot, 0.2);
    world.step(10);
    const double before = turned.back(world.pose(footbot).position).y();
    world.step(5);
    return (turned.back(world.pose(footbot).position).y() - before) / 0.5;
  }
};

TEST_P(WallTest, ARobotGoesAlongAWallAtOneSpeed) {
  const Case& values = GetParam();
  const double in_plane = speedAlong(dynamics2dWorld(values.friction, values.subclock));
  const double in_space = speedAlong(dynamics3dWorld(values.friction, values.subclock));
  EXPECT_NEAR(in_plane, in_space, kAgree * std::abs(in_space));
  if (values.friction == 0.0) {
    EXPECT_NEAR(speedAlong(PlanarWorld<kinematics2d::Kinematics2d>()), in_space, kAgree * std::abs(in_space));
  }
}

INSTANTIATE_TEST_SUITE_P(Walls, WallTest,
                         testing::Values(Case{0.0, 57.0, 0.29, "10"}, Case{0.0, 63.0, 2.1, "20"},
                                         Case{0.0, -52.0, -1.4, "16"}, Case{0.3, 60.0, 0.29, "10"},
                                         Case{0.6, 66.0, 1.13, "14"}, Case{0.41, -71.0, 2.6, "20"}));

struct SqueezeCase {
  double friction;
  double mass;  // kg, of the block
  double turn;
  double speed;  // of the robot that pushes the block along the wall [m/s]
};

void PrintTo(const SqueezeCase& values, std::ostream* out) {
  *out << "friction " << values.friction << ", " << values.mass << " kg";
}

class SqueezeTest : public testing::TestWithParam<SqueezeCase> {
 protected:
  template <class World>
  static double wayAlong(World world) {
    const SqueezeCase& values = GetParam();
    const TurnedFrame turned(values.turn);
    world.add(blockModel({0.1, 6.0, 0.5}), turned.at(0.05, 0.0, 0.0, 0.25));
    const Row block = world.add(blockModel({0.2, 0.2, 0.2}, values.mass), turned.at(-0.1005, 0.0, 0.0, 0.1));
    const Row presser = addFootbot(world, turned.at(-0.32, 0.0, 0.0));
    const Row pusher = addFootbot(world, turned.at(-0.1, -0.215, 0.5 * M_PI));
    world.drive(presser, 0.1);
    world.step(15);
    world.drive(pusher, values.speed);
    world.step(30);
    return turned.back(world.pose(block).position).y();
  }
};

TEST_P(SqueezeTest, APressedBlockGoesAsFar) {
  const SqueezeCase& values = GetParam();
  const double in_plane = wayAlong(dynamics2dWorld(values.friction, "10"));
  const double in_space = wayAlong(dynamics3dWorld(values.friction, "10"));
  EXPECT_NEAR(in_plane, in_space, std::max(5e-4, kAgree * in_space));
}

INSTANTIATE_TEST_SUITE_P(Blocks, SqueezeTest,
                         testing::Values(SqueezeCase{0.8, 1.0, 0.4, 0.08}, SqueezeCase{0.1, 1.0, 1.9, 0.08},
                                         SqueezeCase{0.2, 2.3, 2.7, 0.06}, SqueezeCase{0.3, 1.7, -1.1, 0.05}));

struct PushCase {
  double friction;
  double offset;  // of the robot's axis from the block's middle [m]
  double mass;    // kg, of the block
  double turn;
};

void PrintTo(const PushCase& values, std::ostream* out) { *out << values.offset << " m off the middle"; }

class OffCentreTest : public testing::TestWithParam<PushCase> {
 protected:
  struct Moved {
    double turn;
    double way;
  };
  template <class World>
  static Moved push(World world) {
    const PushCase& values = GetParam();
    const TurnedFrame turned(values.turn);
    const Row block = world.add(blockModel({0.2, 0.6, 0.2}, values.mass), turned.at(0.0, 0.0, 0.0, 0.1));
    const Row footbot = addFootbot(world, turned.at(-0.1 - 0.085 - 1e-3, values.offset, M_PI));
    world.drive(footbot, -0.058);
    world.step(35);
    return {turned.heading(world.pose(block)), turned.back(world.pose(block).position).x()};
  }
};

TEST_P(OffCentreTest, ABlockOnItsCornersTurnsAlike) {
  const PushCase& values = GetParam();
  const Moved in_plane = push(dynamics2dWorld(values.friction, "10"));
  const Moved in_space = push(dynamics3dWorld(values.friction, "10"));
  EXPECT_NEAR(in_plane.turn, in_space.turn, kAgree * std::abs(in_space.turn));
  EXPECT_NEAR(in_plane.way, in_space.way, kAgree * in_space.way);
  EXPECT_GT(std::abs(in_space.turn), 0.1);
}

INSTANTIATE_TEST_SUITE_P(Blocks, OffCentreTest,
                         testing::Values(PushCase{0.1, 0.05, 2.0, 0.4}, PushCase{0.1, 0.11, 0.8, -1.9},
                                         PushCase{0.3, 0.17, 1.7, 2.6}, PushCase{0.3, -0.23, 1.7, 2.6}));

}  // namespace
}  // namespace swarmanoid
