// Results do not depend on the position in the world, its axes, or the past: a world that is moved, turned, mirrored,
// set upright or restarted in the middle of a run behaves the same.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "world.hpp"

namespace swarmanoid::dynamics2d {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

using Places = std::array<Vector2d, 2>;

/// Two footbots that push against each other. @param aside lateral offset of their middles [m]
Places startsOf(double aside) { return {Vector2d(-0.13, -0.5 * aside), Vector2d(0.13, 0.5 * aside)}; }

/// Their places after 12 s, relative to the place where they met.
Places pushEachOther(const Vector2d& middle, double heading, double aside) {
  World world({100.0, 100.0, 2.0}, 4);
  const Eigen::Rotation2Dd turn(heading);
  std::array<Row, 2> rows{};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Vector2d place = middle + turn * startsOf(aside)[i];
    rows[i] = world.addFootbot(flatPose(place.x(), place.y(), heading + (i == 0 ? 0.0 : M_PI)));
    world.drive(rows[i], 0.15);
  }
  world.step(120);
  Places ends;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    ends[i] = turn.inverse() * (world.pose(rows[i]).position.head<2>() - middle);
  }
  return ends;
}

TEST(IsotropyTest, AHeadOnPushIsTheSameWhereverAndHoweverItIsTurned) {
  for (const double aside : {0.0, 0.013}) {
    const Places expected = pushEachOther({50.0, 50.0}, 0.0, aside);
    for (const double heading : {0.0, 0.37, 1.3, -2.2, 3.0}) {
      for (const Vector2d& middle : {Vector2d(50.0, 50.0), Vector2d(3.1, 7.7), Vector2d(88.8, 12.3)}) {
        const Places found = pushEachOther(middle, heading, aside);
        for (std::size_t i = 0; i < found.size(); ++i) {
          EXPECT_LT((found[i] - expected[i]).norm(), 1e-6) << aside << " " << heading << " " << middle.transpose();
        }
      }
    }
  }
}

TEST(IsotropyTest, AHeadOnPushThatIsMirroredEndsMirrored) {
  const Places left = pushEachOther({50.0, 50.0}, 0.37, 0.013);
  const Places right = pushEachOther({50.0, 50.0}, 0.37, -0.013);
  for (std::size_t i = 0; i < left.size(); ++i) {
    EXPECT_GT(std::abs(left[i].y()), 0.02) << "they slide off each other";
    EXPECT_LT((Vector2d(left[i].x(), -left[i].y()) - right[i]).norm(), 1e-6);
  }
}

TEST(IsotropyTest, PlanesThatStandRunAsTheLevelOne) {
  // two pucks that meet off their middles, and slide on their planes until friction stops them
  std::vector<Places> ends;
  for (const char axis : {'z', 'x', 'y'}) {
    World world({10.0, 10.0, 10.0}, 4, std::string(1, axis), 5.0);
    const planar::Plane plane(axis, 5.0);
    const Eigen::Quaterniond upright = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), plane.normal());
    std::array<Row, 2> rows{};
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double side = i == 0 ? -1.0 : 1.0;
      const Vector2d place(4.0 + 0.16 * side, 4.0 + 0.03 * side);
      rows[i] = world.addToSpace(cylindricPreyModel(0.15, 0.3, 1.1), {plane.toGlobal(place, 5.0), upright});
      world.space.entities.twist[rows[i]].linear = plane.toGlobal(Vector2d(-0.7 * side, 0.0), 0.0);
      test::carryOut(world.space);
      world.engine.add(world.space, rows[i], Role::kMove);
    }
    world.step(20);
    ends.push_back({plane.toLocal(world.pose(rows[0]).position), plane.toLocal(world.pose(rows[1]).position)});
  }
  EXPECT_GT((ends[0][0] - Vector2d(3.84, 3.97)).norm(), 0.01) << "they move";
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LT((ends[1][i] - ends[0][i]).norm(), 1e-9);
    EXPECT_LT((ends[2][i] - ends[0][i]).norm(), 1e-9);
  }
}

TEST(RestartTest, ACrowdThatIsBegunAnewInTheMiddleGoesOnAsItWas) {
  // small islands keep only poses and velocities from tick to tick
  const auto driven = [](World& world, const std::vector<Pose>& poses, const std::vector<Twist>& twists) {
    world.addBlock({0.1, 4.0, 0.5}, {2.0, 2.0, 0.25});
    std::vector<Row> rows;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const Row row = world.addFootbot(poses[i]);
      world.engine.remove(world.space, row);
      world.space.entities.twist[row] = twists[i];
      world.engine.add(world.space, row, Role::kMove);
      world.drive(row, 0.2, 0.03 * static_cast<double>(i));
      rows.push_back(row);
    }
    return rows;
  };
  std::vector<Pose> poses;
  for (int i = 0; i < 12; ++i) {
    poses.push_back(flatPose(1.0 + 0.23 * (i % 3), 1.5 + 0.21 * (i / 3), 0.05 * i));
  }
  World first({10.0, 10.0, 2.0}, 4);
  const std::vector<Row> rows = driven(first, poses, std::vector<Twist>(poses.size()));
  first.step(40);
  std::vector<Twist> twists;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    poses[i] = first.pose(rows[i]);
    twists.push_back(first.twist(rows[i]));
  }
  World second({10.0, 10.0, 2.0}, 4);
  const std::vector<Row> again = driven(second, poses, twists);
  first.step(3);
  second.step(3);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_LT((first.pose(rows[i]).position - second.pose(again[i]).position).norm(), 1e-9) << i;
  }
}

}  // namespace
}  // namespace swarmanoid::dynamics2d
