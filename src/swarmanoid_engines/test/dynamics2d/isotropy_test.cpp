// Nothing depends on where in the world bodies are, nor on its axes: what is moved or turned runs the same.
#include <gtest/gtest.h>

#include <array>

#include "world.hpp"

namespace swarmanoid::dynamics2d {
namespace {

using Eigen::Vector2d;

/// Where two footbots are that pushed against each other for 12 s, seen from where they met.
std::array<Vector2d, 2> pushEachOther(const Vector2d& middle, double heading, double aside) {
  World world({100.0, 100.0, 2.0}, 4);
  const Eigen::Rotation2Dd turn(heading);
  std::array<Row, 2> rows{};
  for (const int i : {0, 1}) {
    const double side = i == 0 ? -1.0 : 1.0;
    const Vector2d place = middle + turn * Vector2d(side * 0.13, 0.5 * side * aside);
    rows[static_cast<std::size_t>(i)] =
        world.addFootbot(flatPose(place.x(), place.y(), heading + (i == 0 ? 0.0 : M_PI)));
    world.drive(rows[static_cast<std::size_t>(i)], 0.15);
  }
  world.step(120);
  std::array<Vector2d, 2> ends;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    ends[i] = turn.inverse() * (world.pose(rows[i]).position.head<2>() - middle);
  }
  return ends;
}

TEST(IsotropyTest, AHeadOnPushIsTheSameWhereverAndHoweverItIsTurned) {
  for (const double aside : {0.0, 0.013}) {
    const auto expected = pushEachOther({50.0, 50.0}, 0.0, aside);
    for (const double heading : {0.0, 0.37, 1.3, -2.2, 3.0}) {
      for (const Vector2d& middle : {Vector2d(50.0, 50.0), Vector2d(3.1, 7.7), Vector2d(88.8, 12.3)}) {
        const auto found = pushEachOther(middle, heading, aside);
        for (std::size_t i = 0; i < found.size(); ++i) {
          EXPECT_LT((found[i] - expected[i]).norm(), 1e-6) << aside << " " << heading << " " << middle.transpose();
        }
      }
    }
  }
}

}  // namespace
}  // namespace swarmanoid::dynamics2d
