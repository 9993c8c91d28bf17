// Outlines wider than a cell of the positional index, such as the walls of a maze: so many that they need a grid of
// their own.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "swarmanoid_space/index/positional_index_visits.hpp"

namespace swarmanoid {
namespace {

using Eigen::Vector3d;

class LargeOutlinesTest : public testing::Test {
 protected:
  LargeOutlinesTest() { index.configure({20.0, 12.0, 3.0}, PositionalIndex::Optimization::k2D, 500); }

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
  Vector3d anywhere() { return {uniform(-2.0, 22.0), uniform(-2.0, 14.0), uniform(0.0, 2.0)}; }
  void addWall() {
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(uniform(-M_PI, M_PI), Vector3d::UnitZ()));
    const auto model = blockModel({uniform(1.5, 6.0), 0.1, uniform(0.2, 1.0)});
    entities.add("wall_" + std::to_string(++count), model, {anywhere(), turn}, {});
  }
  /// Brute-force result.
  std::vector<Row> expected(const Vector3d& centre, double radius) const {
    std::vector<Row> found;
    for (const PositionalIndex::LargeOutline& large : index.large()) {
      if (large.meets(centre, radius)) {
        found.push_back(large.row);
      }
    }
    std::sort(found.begin(), found.end());
    return found;
  }
  std::vector<Row> found(const Vector3d& centre, double radius) const {
    std::vector<Row> rows;
    index.visitLarge(centre, radius, [&](const PositionalIndex::LargeOutline& large) {
      rows.push_back(large.row);
      return true;
    });
    std::sort(rows.begin(), rows.end());
    return rows;
  }

  std::mt19937 random{17};
  Entities entities;
  PositionalIndex index;
  int count = 0;
};

TEST_F(LargeOutlinesTest, AreFoundWhereTheyAreAsTheyComeMoveAndGo) {
  for (int i = 0; i < 70; ++i) {
    addWall();
  }
  std::size_t sum = 0;
  for (int round = 0; round < 60; ++round) {
    const Row row = entities.order[random() % entities.size()];
    entities.pose[row].position = anywhere();
    if (round % 3 == 0) {
      entities.remove(entities.order[random() % entities.size()]);  // down to a number without a grid
      entities.remove(entities.order[random() % entities.size()]);
      entities.remove(entities.order[random() % entities.size()]);
    } else if (round % 7 == 0) {
      addWall();
    }
    index.rebuild(entities);
    ASSERT_EQ(index.large().size(), entities.size());
    for (int i = 0; i < 40; ++i) {
      const Vector3d centre = anywhere();
      const double radius = uniform(0.0, 3.0);
      ASSERT_EQ(found(centre, radius), expected(centre, radius)) << "round " << round;
      sum += found(centre, radius).size();
    }
  }
  EXPECT_LT(entities.size(), 20U);
  EXPECT_GT(sum, 5000U);
}

TEST_F(LargeOutlinesTest, AreVisitedUntilSomebodyHasSeenEnough) {
  for (int i = 0; i < 40; ++i) {
    addWall();
  }
  index.rebuild(entities);
  int visits = 0;
  index.visitLarge({10.0, 6.0, 1.0}, 30.0, [&](const PositionalIndex::LargeOutline&) { return ++visits < 3; });
  EXPECT_EQ(visits, 3);
}

}  // namespace
}  // namespace swarmanoid
