#include "swarmanoid_space/rays/entities_without_engine.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "swarmanoid_space/rays/solid_ray.hpp"

namespace swarmanoid {
namespace {

using Eigen::Vector3d;

class EntitiesWithoutEngineTest : public testing::Test {
 protected:
  EntitiesWithoutEngineTest() { lone.configure({kSide, kSide, 2.0}); }

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
  /// Returns a pose, mostly in the arena, sometimes outside.
  Pose anywhere() {
    const Vector3d axis(uniform(-0.2, 0.2), uniform(-0.2, 0.2), 1.0);
    return {{uniform(-2.0, kSide + 2.0), uniform(-2.0, kSide + 2.0), uniform(0.0, 0.5)},
            Eigen::Quaterniond(Eigen::AngleAxisd(uniform(-M_PI, M_PI), axis.normalized()))};
  }
  Row add(const std::shared_ptr<const EntityModel>& model, const Pose& pose) {
    const Row row = entities.add("e" + std::to_string(++count), model, pose, {});
    lone.place(entities, row);
    return row;
  }
  /// Brute-force result.
  double nearest(const Segment& segment, Row ignored) const {
    double fraction = 1.0;
    for (const Row row : entities.order) {
      if (row != ignored && lone.has(row)) {
        fraction = std::min(fraction, closestHit(segment, *entities.model[row], entities.pose[row]));
      }
    }
    return fraction;
  }
  RayHit cast(const Segment& segment, Row ignored = kNoRow) const {
    RayBundle bundle;
    bundle.segments = Span<const Segment>(&segment, 1);
    bundle.centre = 0.5 * (segment.from + segment.to);
    bundle.radius = 0.5 * (segment.to - segment.from).norm();
    bundle.ignored = ignored;
    RayHit hit;
    lone.raycast(entities, bundle, Span<RayHit>(&hit, 1));
    EXPECT_TRUE(lone.mayHit(bundle) || !hit.isHit());
    return hit;
  }

  static constexpr double kSide = 7.3;
  Entities entities;
  EntitiesWithoutEngine lone;
  std::mt19937 random{21};
  int count = 0;
};

TEST_F(EntitiesWithoutEngineTest, RaysHitWhatALookAtEachFindsAsTheyComeMoveAndGo) {
  std::vector<Row> rows;
  for (int i = 0; i < 120; ++i) {
    const Vector3d size(uniform(0.05, 2.5), uniform(0.05, 0.4), uniform(0.1, 1.0));
    rows.push_back(add(i % 3 == 0 ? cylindricPreyModel(0.1, 0.3) : blockModel(size), anywhere()));
  }
  int hits = 0;
  for (int i = 0; i < 3000; ++i) {
    const Row row = rows[random() % rows.size()];
    if (i % 10 == 0) {
      entities.pose[row] = anywhere();
      lone.place(entities, row);
    } else if (i % 97 == 0) {
      lone.remove(row);
      EXPECT_FALSE(lone.has(row));
    }
    const Vector3d from = anywhere().position;
    const Segment segment{from, from + Vector3d(uniform(-2.0, 2.0), uniform(-2.0, 2.0), uniform(-0.3, 0.3))};
    const RayHit hit = cast(segment, row);
    ASSERT_EQ(hit.fraction, nearest(segment, row)) << i;
    hits += hit.isHit() ? 1 : 0;
  }
  EXPECT_GT(hits, 500);
  EXPECT_LT(hits, 2900);
}

TEST_F(EntitiesWithoutEngineTest, BetweenSurfacesAtTheSameDistanceTheOlderIsHit) {
  const Row older = add(blockModel({0.1, 4.0, 1.0}), {{3.0, 3.5, 0.5}, Eigen::Quaterniond::Identity()});
  const Row younger = add(blockModel({0.1, 1.0, 1.0}), {{3.0, 3.5, 0.5}, Eigen::Quaterniond::Identity()});
  const Segment segment{{2.5, 3.4, 0.4}, {3.5, 3.4, 0.4}};
  EXPECT_EQ(cast(segment).row, older);
  EXPECT_EQ(cast(segment, older).row, younger);
  lone.place(entities, older);
  EXPECT_EQ(cast(segment).row, older);
  lone.clear();
  EXPECT_TRUE(lone.isEmpty());
  EXPECT_FALSE(cast(segment).isHit());
}

}  // namespace
}  // namespace swarmanoid
