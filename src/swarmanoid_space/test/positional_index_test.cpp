// Range queries give the same result as brute force, in 2D and 3D, wherever the entities are.
#include "swarmanoid_space/index/positional_index.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "swarmanoid_space/index/positional_index_visits.hpp"

namespace swarmanoid {
namespace {

using Eigen::Vector3d;
using Optimization = PositionalIndex::Optimization;

constexpr double kEverything = 1e6;

class PositionalIndexTest : public testing::TestWithParam<Optimization> {
 protected:
  void SetUp() override { index.configure({10.0, 6.0, 3.0}, GetParam(), 200); }

  Row add(const std::shared_ptr<const EntityModel>& model, const Vector3d& position) {
    return entities.add("e" + std::to_string(++count_), model, {position, Eigen::Quaterniond::Identity()}, {});
  }

  /// Returns a position in the arena, near its border, or far outside.
  Vector3d anywhere() {
    std::uniform_real_distribution<double> inside(-1.0, 11.0);
    std::uniform_real_distribution<double> far(-100.0, 100.0);
    auto& place = std::uniform_int_distribution<int>(0, 9)(random) == 0 ? far : inside;
    return {place(random), place(random), place(random)};
  }

  /// Adds preys, lamps (without a body), and walls wider than a cell.
  void fill(int quantity) {
    for (int i = 0; i < quantity; ++i) {
      add(i % 5 == 0 ? lightModel() : cylindricPreyModel(0.02 + 0.001 * (i % 50), 0.1 + 0.01 * (i % 30)), anywhere());
    }
    add(blockModel({8.0, 0.1, 1.0}), {5.0, 3.0, 0.5});
    add(blockModel({0.1, 5.0, 2.0}), {-3.0, 2.0, 0.5});
    index.rebuild(entities);
  }

  /// Brute-force result: entities with their origin within the radius, in the order of entity numbers.
  std::vector<Row> byLookingAtEach(const Vector3d& centre, double radius, Row but = kNoRow) const {
    std::vector<Row> found;
    for (const Row row : entities.order) {
      if (row != but && (entities.pose[row].position - centre).squaredNorm() <= radius * radius) {
        found.push_back(row);
      }
    }
    return found;
  }

  double distance(Row row, const Vector3d& centre) const { return (entities.pose[row].position - centre).norm(); }

  std::vector<Row> collected(const Vector3d& centre, double radius) const {
    std::vector<Row> found;
    index.collect(centre, radius, found);
    std::sort(found.begin(), found.end());
    return found;
  }

  std::mt19937 random{20260101};
  Entities entities;
  PositionalIndex index;

 private:
  int count_ = 0;
};

TEST_P(PositionalIndexTest, FindsAroundAPointWhatALookAtEachFinds) {
  fill(500);
  std::uniform_real_distribution<double> reach(0.0, 4.0);
  std::size_t found = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vector3d centre = anywhere();
    const double radius = reach(random);
    const std::vector<Row> expected = byLookingAtEach(centre, radius);
    ASSERT_EQ(index.within(entities, centre, radius), expected) << centre.transpose() << " radius " << radius;
    found += expected.size();
  }
  EXPECT_GT(found, 10000U);
}

TEST_P(PositionalIndexTest, FindsAroundAnEntityAllButItself) {
  fill(500);
  std::uniform_real_distribution<double> reach(0.0, 4.0);
  for (const Row row : entities.order) {
    const double radius = reach(random);
    ASSERT_EQ(index.within(entities, row, radius), byLookingAtEach(entities.pose[row].position, radius, row));
  }
}

TEST_P(PositionalIndexTest, AnOriginExactlyAtTheRadiusIsFoundAcrossCellBorders) {
  // lamps have no extent, so only the origin decides
  for (int x = -8; x <= 108; ++x) {
    for (int y = -2; y <= 8; ++y) {
      add(lightModel(), {0.1 * x, 0.1 * y, 0.1 * (y % 3)});
    }
  }
  index.rebuild(entities);
  for (int i = 0; i < 3000; ++i) {
    std::uniform_int_distribution<int> tenth(-10, 110);
    const Vector3d centre(0.1 * tenth(random), 0.1 * (tenth(random) % 8), 0.1 * (tenth(random) % 3));
    const double radius = 0.1 * (tenth(random) % 10);
    ASSERT_EQ(index.within(entities, centre, std::abs(radius)), byLookingAtEach(centre, std::abs(radius)))
        << centre.transpose() << " radius " << radius;
  }
}

TEST_P(PositionalIndexTest, RoundingAtACellBorderLosesNothing) {
  index.configure({8.0, 8.0, 8.0}, GetParam(), GetParam() == Optimization::k2D ? 256 : 4096);  // cells of half a metre
  const double below_border = std::nextafter(0.5, 0.0);
  const Row row = add(lightModel(), {below_border, 1.0, 1.0});
  index.rebuild(entities);
  const double radius = 1.0 - below_border;  // rounds to 0.5, and 1 - 0.5 is in the next cell
  EXPECT_EQ(index.within(entities, {1.0, 1.0, 1.0}, radius), std::vector<Row>{row});
}

TEST_P(PositionalIndexTest, NoRadiusFindsWhatIsExactlyThereAndAHugeOneFindsAll) {
  fill(300);
  const Row twin = add(lightModel(), entities.pose[rowAt(7)].position);
  index.rebuild(entities);
  EXPECT_EQ(index.within(entities, entities.pose[rowAt(7)].position, 0.0), (std::vector<Row>{rowAt(7), twin}));
  EXPECT_EQ(index.within(entities, rowAt(7), 0.0), std::vector<Row>{twin});
  for (const double radius : {kEverything, 1e200, std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(index.within(entities, {5.0, 3.0, 0.0}, radius), entities.order);
    EXPECT_EQ(collected({5.0, 3.0, 0.0}, radius).size(), entities.size());
  }
}

TEST_P(PositionalIndexTest, CollectsAllBoundsThatMeetTheSphereOnceAndNoneFarOff) {
  fill(500);
  std::uniform_real_distribution<double> reach(0.0, 2.0);
  for (int i = 0; i < 2000; ++i) {
    const Vector3d centre = anywhere();
    const double radius = reach(random);
    const std::vector<Row> found = collected(centre, radius);
    ASSERT_EQ(std::adjacent_find(found.begin(), found.end()), found.end()) << "found twice";
    for (const Row row : entities.order) {
      const EntityModel& model = *entities.model[row];
      const bool is_found = std::binary_search(found.begin(), found.end(), row);
      // a body around its origin meets the sphere if its origin is inside; a body outside a cylinder around the sphere
      // does not
      ASSERT_TRUE(is_found || distance(row, centre) > radius) << model.type;
      ASSERT_FALSE(is_found && distance(row, centre) > std::sqrt(2.0) * radius + 2.0 * model.bounding_radius);
    }
  }
}

TEST_P(PositionalIndexTest, AnUprightCylinderMeetsWhateverIsBesideItsAxisAtAnyHeight) {
  fill(500);
  std::uniform_real_distribution<double> reach(0.0, 4.0);
  std::size_t met = 0;
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector2d axis = anywhere().head<2>();
    const double radius = reach(random);
    std::vector<Row> found;
    index.collectUpright(axis, radius, found);
    std::sort(found.begin(), found.end());
    std::vector<Row> expected;
    for (const Row row : entities.order) {
      const EntityModel& model = *entities.model[row];
      const double way = (axis - entities.pose[row].position.head<2>()).norm();
      if (model.type != "block" && way <= radius + model.horizontal_radius) {
        expected.push_back(row);
      }
    }
    for (const PositionalIndex::LargeOutline& large : index.large()) {
      // at a height within its own, the query is that of the sphere
      const Vector3d beside(axis.x(), axis.y(), large.bounds.center().z());
      if (large.meets(beside, radius)) {
        expected.push_back(large.row);
      }
    }
    std::sort(expected.begin(), expected.end());
    ASSERT_EQ(found, expected) << axis.transpose() << " radius " << radius;
    met += found.size();
  }
  EXPECT_GT(met, 10000U);
}

/// The outline of an upright prey is its body, that of a lamp a point.
TEST_P(PositionalIndexTest, PlacesAreThoseWhoseOutlinesMeetTheSphere) {
  fill(500);
  EXPECT_EQ(index.placeCount(), 500U) << "walls have none";
  ASSERT_EQ(index.large().size(), 2U);
  std::uniform_real_distribution<double> reach(0.0, 4.0);
  std::size_t met = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vector3d centre = anywhere();
    const double radius = reach(random);
    std::vector<PositionalIndex::Place> places;
    index.collectPlaces(centre, radius, places);
    std::vector<Row> found;
    for (const PositionalIndex::Place place : places) {
      ASSERT_LT(place, index.placeCount());
      found.push_back(index.at(place).row);
    }
    std::sort(found.begin(), found.end());
    std::vector<Row> expected;
    for (const Row row : entities.order) {
      const EntityModel& model = *entities.model[row];
      const Vector3d way = centre - entities.pose[row].position;
      if (model.type != "block" && way.head<2>().norm() <= radius + model.horizontal_radius &&
          way.z() + radius >= model.lowest && way.z() - radius <= model.highest) {
        expected.push_back(row);
      }
    }
    std::sort(expected.begin(), expected.end());
    ASSERT_EQ(found, expected) << centre.transpose() << " radius " << radius;
    met += found.size();
  }
  EXPECT_GT(met, 3000U);
}

/// A sphere on a link folded over the body's origin. @param length of the link, and height of its joint [m]
std::shared_ptr<const EntityModel> foldedArm(double length) {
  auto model = std::make_shared<EntityModel>();
  model->joints.resize(1);
  model->joints[0].axis = Vector3d::UnitY();
  model->joints[0].frame.position = {length, 0.0, length};
  CollisionShape hand;
  hand.kind = CollisionShape::Kind::kSphere;
  hand.half_extent.setConstant(0.01);
  hand.position = {0.0, 0.0, length};
  hand.joint = 0;
  model->shapes.push_back(hand);
  model->measureShapes();
  return model;
}

TEST_P(PositionalIndexTest, AnArmIsFoundWhereverItMayTurn) {
  // the first is in a cell, the second is a large outline
  for (const double length : {0.1, 0.9}) {
    const Row row = add(foldedArm(length), {4.0, 3.0, 0.0});
    index.rebuild(entities);
    EXPECT_EQ(index.large().size(), length > 0.5 ? 1U : 0U);
    EXPECT_EQ(collected({4.0 + 2.0 * length, 3.0, length}, 0.02), std::vector<Row>{row}) << "stretched ahead";
    EXPECT_EQ(collected({4.0 + length, 3.0, 2.0 * length}, 0.02), std::vector<Row>{row}) << "turned up";
    EXPECT_TRUE(collected({4.0 + 4.0 * length, 3.0, length}, 0.02).empty()) << "no arm is so long";
    entities.remove(row);
  }
}

TEST_P(PositionalIndexTest, FollowsWhatMovesComesAndGoes) {
  fill(200);
  for (int round = 0; round < 30; ++round) {
    for (int i = 0; i < 20; ++i) {
      const Row row = entities.order[static_cast<std::size_t>(random() % entities.size())];
      switch (random() % 3) {
        case 0:
          entities.remove(row);
          break;
        case 1:
          entities.pose[row].position = anywhere();
          break;
        default:
          add(cylindricPreyModel(0.05, 0.1), anywhere());
      }
    }
    index.rebuild(entities);
    for (int i = 0; i < 50; ++i) {
      const Vector3d centre = anywhere();
      ASSERT_EQ(index.within(entities, centre, 2.0), byLookingAtEach(centre, 2.0));
    }
  }
}

/// Queries after a long pause, and first queries, give the result of an index that is rebuilt each time.
TEST_P(PositionalIndexTest, IsUpToDateWhoeverAsksAndWhenever) {
  fill(40);
  PositionalIndex fresh;
  fresh.configure({10.0, 6.0, 3.0}, GetParam(), 200);
  for (int tick = 0; tick < 200; ++tick) {
    index.close();
    for (const Row row : entities.order) {
      entities.pose[row].position += Vector3d(0.2, -0.1, 0.05) * std::uniform_real_distribution<double>(-1, 1)(random);
    }
    index.update(entities);
    if (tick % 3 == 0) {  // between ticks
      entities.remove(entities.order[static_cast<std::size_t>(tick) % entities.order.size()]);
      index.forget(entities);
      add(cylindricPreyModel(0.05, 0.1), anywhere());
      index.forget(entities);
      entities.pose[entities.order.front()].position = anywhere();
      index.forget(entities);
    }
    if (tick % 7 < 4) {  // queries in some consecutive ticks, and none in others
      fresh.rebuild(entities);
      const Vector3d centre = anywhere();
      std::vector<Row> expected;
      fresh.collect(centre, 1.0, expected);
      std::vector<Row> found;
      index.collect(centre, 1.0, found);
      ASSERT_EQ(found, expected) << "tick " << tick;
      ASSERT_EQ(index.within(entities, centre, 2.0), byLookingAtEach(centre, 2.0)) << "tick " << tick;
      ASSERT_EQ(index.placeCount(), fresh.placeCount());
      ASSERT_EQ(index.large().size(), fresh.large().size());
    }
  }
}

/// The first queries rebuild the index, possibly on many threads at once.
TEST_P(PositionalIndexTest, ManyThreadsMayAskFirst) {
  fill(2000);
  for (int round = 0; round < 30; ++round) {
    for (const Row row : entities.order) {
      entities.pose[row].position = anywhere();
    }
    index.forget(entities);
    const Vector3d centre(5.0, 3.0, 1.0);
    std::vector<std::vector<Row>> found(8);
    std::vector<std::thread> threads;
    for (auto& of_thread : found) {
      threads.emplace_back([&] { of_thread = index.within(entities, centre, 3.0); });
    }
    for (std::thread& thread : threads) {
      thread.join();
    }
    EXPECT_EQ(found, std::vector<std::vector<Row>>(8, byLookingAtEach(centre, 3.0))) << "round " << round;
  }
}

TEST_P(PositionalIndexTest, ResultsComeByEntityNumberWhateverTheRows) {
  const Row first = add(lightModel(), {1.0, 1.0, 0.0});
  const Row second = add(lightModel(), {1.1, 1.0, 0.0});
  entities.remove(first);
  const Row third = add(lightModel(), {0.9, 1.0, 0.0});
  ASSERT_EQ(third, first) << "the row is used again";
  index.rebuild(entities);
  EXPECT_EQ(index.within(entities, {1.0, 1.0, 0.0}, 0.5), (std::vector<Row>{second, third}));
}

TEST_P(PositionalIndexTest, PairsAreAllThatAreThatNearSeenFromAboveEachOnce) {
  fill(500);
  const auto any = [](Row) { return true; };
  for (const double distance : {0.0, 0.13, 0.9, 3.7, 250.0}) {
    std::vector<std::pair<Row, Row>> found;
    index.visitPairs(entities, distance, any, [&](Row one, Row other, double square) {
      EXPECT_EQ(square, (entities.pose[one].position - entities.pose[other].position).head<2>().squaredNorm());
      found.emplace_back(std::minmax(one, other));
    });
    std::sort(found.begin(), found.end());
    std::vector<std::pair<Row, Row>> expected;
    for (std::size_t i = 0; i < entities.order.size(); ++i) {
      for (std::size_t k = i + 1; k < entities.order.size(); ++k) {
        const Row one = entities.order[i];
        const Row other = entities.order[k];
        if ((entities.pose[one].position - entities.pose[other].position).head<2>().squaredNorm() <=
            distance * distance) {
          expected.emplace_back(std::minmax(one, other));
        }
      }
    }
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(found, expected) << distance;
  }
}

TEST_P(PositionalIndexTest, PairsLeaveOutWhatIsLargeAndNotMeant) {
  fill(50);
  const std::vector<PositionalIndex::LargeOutline>& large = index.large();
  ASSERT_EQ(large.size(), 2U);
  std::size_t with_large = 0;
  std::size_t all = 0;
  const auto is_meant = [&](Row row) { return row == large[1].row; };
  index.visitPairs(entities, kEverything, is_meant, [&](Row one, Row other, double) {
    EXPECT_NE(one, large[0].row);
    EXPECT_NE(other, large[0].row);
    with_large += one == large[1].row || other == large[1].row ? 1 : 0;
    ++all;
  });
  EXPECT_EQ(with_large, 50U);
  EXPECT_EQ(all, 50U + 50U * 49U / 2U);
}

TEST_P(PositionalIndexTest, WithNothingInItFindsNothing) {
  index.rebuild(entities);
  EXPECT_TRUE(index.within(entities, {5.0, 3.0, 0.0}, kEverything).empty());
  EXPECT_TRUE(collected({5.0, 3.0, 0.0}, kEverything).empty());
}

INSTANTIATE_TEST_SUITE_P(Optimizations, PositionalIndexTest, testing::Values(Optimization::k2D, Optimization::k3D),
                         [](const auto& optimization) {
                           return optimization.param == Optimization::k2D ? "In2D" : "In3D";
                         });

}  // namespace
}  // namespace swarmanoid
