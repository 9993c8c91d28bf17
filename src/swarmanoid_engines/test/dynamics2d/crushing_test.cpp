// Neither a mirror nor a wall yields: a robot between them stays on its side of the wall, and is free later.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "world.hpp"

namespace swarmanoid::dynamics2d {
namespace {

using Eigen::Vector3d;

constexpr double kHalfWidth = 0.088;  // m: of a footbot along its axle, treels included; its body is a disc of 85 mm
constexpr double kStep = 0.025;       // s

struct Case {
  double wall_heading;  // rad
  double skew;          // of the footbot's axle, from the normal of the wall [rad]
  double thickness;     // m
  bool is_mirror_square = false;
};

/// A footbot that touches a wall with a treel, and a mirror elsewhere.
struct AtWall {
  explicit AtWall(const Case& which)
      : across(Eigen::AngleAxisd(which.wall_heading, Vector3d::UnitZ()) * Vector3d::UnitY()),
        side(Vector3d(2.7, 3.1, 0.0) + 0.5 * which.thickness * across) {
    world.addBlock({4.0, which.thickness, 0.5}, {2.7, 3.1, 0.25}, which.wall_heading);
    const Vector3d place = side + kHalfWidth * across;
    footbot = world.addFootbot(flatPose(place.x(), place.y(), which.wall_heading + which.skew));
    const auto model = which.is_mirror_square ? blockModel({0.1, 0.1, 0.1}, 1.0) : cylindricPreyModel(0.05, 0.1);
    mirror = world.add(model, flatPose(5.0, 5.0, which.wall_heading + 0.3), Role::kMirror);
  }

  /// Distance of the footbot's middle from the wall's side [m].
  double distance() const { return (world.pose(footbot).position - side).dot(across); }
  /// Runs ticks with the mirror at places in front of the wall. @param places their distances from the wall's side [m]
  /// @return the footbot's least distance [m]
  double press(const std::vector<double>& places) {
    double nearest = distance();
    for (const double place : places) {
      world.pose(mirror).position = world.pose(footbot).position + (place - distance()) * across;
      world.step();
      nearest = std::min(nearest, distance());
    }
    world.pose(mirror).position = Vector3d(5.0, 5.0, 0.0);
    world.space.entities.twist[mirror].linear.setZero();
    return nearest;
  }
  /// Drives for two seconds. @return largest speed [m/s]
  double drive(double speed, double turn_rate) {
    world.drive(footbot, speed, turn_rate);
    double fastest = 0.0;
    for (int i = 0; i < 20; ++i) {
      world.step();
      fastest = std::max(fastest, world.twist(footbot).linear.norm());
    }
    return fastest;
  }

  Vector3d across;  // away from the wall
  Vector3d side;    // the middle of the wall's side
  World world{{6.0, 6.0, 2.0}, 4};
  Row footbot = kNoRow;
  Row mirror = kNoRow;
};

class CrushingTest : public ::testing::TestWithParam<Case> {
 protected:
  /// Expects that the footbot is out of the wall, on its side, and drives as a robot that was always there.
  void expectFreedom() {
    crushed.world.step(2);
    EXPECT_GT(crushed.distance(), 0.085 - 3e-4);
    AtWall other(GetParam());
    other.world.engine.remove(other.world.space, other.footbot);
    other.world.pose(other.footbot) = crushed.world.pose(crushed.footbot);
    other.world.engine.add(other.world.space, other.footbot, Role::kMove);
    EXPECT_NEAR(crushed.drive(0.13, 1.9), other.drive(0.13, 1.9), 2e-3);
    const Vector3d apart = crushed.world.pose(crushed.footbot).position - other.world.pose(other.footbot).position;
    EXPECT_LT(apart.norm(), 0.03);
  }

  AtWall crushed{GetParam()};
};

TEST_P(CrushingTest, BetweenAWallAndAMirrorThatIsPutUponItAFootbotStaysOnItsSide) {
  // a mirror that is placed onto a body pushes it with at most 0.3 m/s, so its depth in the wall is at most the way of
  // one step at that speed
  EXPECT_GT(crushed.press(std::vector<double>(30, 0.09)), 0.085 - 0.3 * kStep - 1e-3);
  expectFreedom();
}

TEST_P(CrushingTest, LikewiseIfTheMirrorsMiddleIsInIt) {
  EXPECT_GT(crushed.press(std::vector<double>(30, kHalfWidth + 0.025)), 0.085 - 0.3 * kStep - 1e-3);
  expectFreedom();
}

TEST_P(CrushingTest, LikewiseIfTheMirrorComesFast) {
  constexpr double kSpeed = 1.0;  // m/s
  crushed.world.space.entities.twist[crushed.mirror].linear = -kSpeed * crushed.across;
  std::vector<double> places;
  for (double place = 0.6; place > -0.6; place -= 0.1 * kSpeed) {
    places.push_back(place);
  }
  EXPECT_GT(crushed.press(places), 0.04);
  expectFreedom();
}

INSTANTIATE_TEST_SUITE_P(Walls, CrushingTest,
                         ::testing::Values(Case{0.0, 0.03, 0.02}, Case{0.7, -0.11, 0.02}, Case{2.3, 0.05, 0.005},
                                           Case{-1.9, -0.02, 0.03}, Case{1.2, 0.04, 0.02, true}));

}  // namespace
}  // namespace swarmanoid::dynamics2d
