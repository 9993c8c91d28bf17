#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <random>
#include <vector>

#include "swarmanoid_space/rays/flat_rays.hpp"
#include "world.hpp"

namespace swarmanoid::kinematics2d {
namespace {

using Eigen::Vector3d;

TEST(RaysTest, ACircleIsHitAtItsNearSide) {
  World world;
  const Row disc = world.add(discModel(0.5, 1.0), flatPose(5.0, 5.0));
  const RayHit hit = world.castRay({3.0, 5.0, 0.5}, {6.0, 5.0, 0.5});
  EXPECT_EQ(hit.row, disc);
  EXPECT_NEAR(hit.fraction, 1.5 / 3.0, 1e-12);
  // off the centre: the half chord at 0.3 is 0.4
  EXPECT_NEAR(world.castRay({3.0, 5.3, 0.5}, {6.0, 5.3, 0.5}).fraction, 1.6 / 3.0, 1e-12);
  EXPECT_EQ(world.castRay({3.0, 5.51, 0.5}, {6.0, 5.51, 0.5}).row, kNoRow);
  EXPECT_EQ(world.castRay({3.0, 5.0, 0.5}, {4.4, 5.0, 0.5}).row, kNoRow);  // too short
}

TEST(RaysTest, ASlantedRayHitsASideOfABox) {
  World world;
  const Row box = world.addBlock({1.0, 2.0, 1.0}, {5.0, 5.0, 0.5});
  const RayHit hit = world.castRay({3.5, 4.0, 0.1}, {5.5, 6.0, 0.9});
  EXPECT_EQ(hit.row, box);
  EXPECT_NEAR(hit.fraction, 0.5, 1e-12);  // x = 4.5 after 1 of 2
}

TEST(RaysTest, ABoxTurnedByAnEighthShowsItsCorner) {
  World world;
  world.addBlock({1.0, 1.0, 1.0}, {5.0, 5.0, 0.5}, M_PI / 4.0);
  EXPECT_NEAR(world.castRay({3.0, 5.0, 0.5}, {5.0, 5.0, 0.5}).fraction, (2.0 - std::sqrt(0.5)) / 2.0, 1e-12);
}

TEST(RaysTest, ARayFromAboveHitsTheTop) {
  World world;
  const Row footbot = world.addFootbot(flatPose(5.0, 5.0));
  const RayHit top = world.castRay({5.0, 5.0, 1.146}, {5.0, 5.0, 0.146 - 1.0});
  EXPECT_EQ(top.row, footbot);
  EXPECT_NEAR(top.fraction, 0.5, 1e-12);
  // the gripper is beside the body, its top at 6.5 cm
  EXPECT_NEAR(world.castRay({5.1, 5.0, 1.0}, {5.1, 5.0, 0.0}).fraction, 0.935, 1e-12);
  EXPECT_EQ(world.castRay({5.2, 5.0, 1.0}, {5.2, 5.0, 0.0}).row, kNoRow);
}

TEST(RaysTest, ARayFromBelowHitsTheUnderside) {
  World world;
  world.addBlock({1.0, 1.0, 0.1}, {5.0, 5.0, 0.75});
  EXPECT_NEAR(world.castRay({5.2, 5.2, 0.2}, {5.2, 5.2, 1.2}).fraction, 0.5, 1e-12);
  EXPECT_EQ(world.castRay({4.0, 5.0, 0.2}, {6.0, 5.0, 0.2}).row, kNoRow);  // under the table
}

TEST(RaysTest, ARayThatStartsInsideHitsAtOnce) {
  World world;
  const Row box = world.addBlock({1.0, 1.0, 1.0}, {5.0, 5.0, 0.5});
  const Row disc = world.add(discModel(0.5, 1.0), flatPose(8.0, 8.0));
  EXPECT_EQ(world.castRay({5.1, 5.1, 0.2}, {9.0, 5.1, 0.2}).row, box);
  EXPECT_EQ(world.castRay({5.1, 5.1, 0.2}, {9.0, 5.1, 0.2}).fraction, 0.0);
  EXPECT_EQ(world.castRay({8.1, 8.1, 0.2}, {8.1, 8.1, 0.3}).row, disc);
  EXPECT_EQ(world.castRay({8.1, 8.1, 0.2}, {8.1, 8.1, 0.2}).fraction, 0.0);  // a point
}

TEST(RaysTest, ARayAlongAFaceOutsideMisses) {
  World world;
  world.addBlock({1.0, 1.0, 1.0}, {5.0, 5.0, 0.5});
  EXPECT_EQ(world.castRay({3.0, 5.5 + 1e-9, 0.5}, {7.0, 5.5 + 1e-9, 0.5}).row, kNoRow);
  EXPECT_NE(world.castRay({3.0, 5.5 - 1e-9, 0.5}, {7.0, 5.5 - 1e-9, 0.5}).row, kNoRow);
}

TEST(RaysTest, TwoEntitiesCanBeIgnoredAndTheNextIsHit) {
  World world;
  std::vector<Row> rows;
  for (int i = 0; i < 3; ++i) {
    rows.push_back(world.add(discModel(0.1, 0.5), flatPose(2.0 + i, 5.0)));
  }
  const Segment segment{{1.0, 5.0, 0.2}, {6.0, 5.0, 0.2}};
  EXPECT_EQ(world.space.castRay(segment).row, rows[0]);
  EXPECT_EQ(world.space.castRay(segment, rows[0]).row, rows[1]);
  EXPECT_EQ(world.space.castRay(segment, rows[1], rows[0]).row, rows[2]);
}

TEST(RaysTest, OfSurfacesInTheSamePlaceTheOlderIsHit) {
  for (const bool reversed : {false, true}) {
    World world;
    const Row first = world.addToSpace(blockModel({1.0, 1.0, 1.0}), flatPose(5.0, 5.5, 0.0, 0.5));
    const Row second = world.addToSpace(blockModel({1.0, 1.0, 1.0}), flatPose(5.0, 4.5, 0.0, 0.5));
    for (const Row row : {reversed ? second : first, reversed ? first : second}) {
      test::carryOut(world.space);
      world.engine.add(world.space, row, Role::kMove);
    }
    EXPECT_EQ(world.castRay({3.0, 5.0, 0.5}, {7.0, 5.0, 0.5}).row, first);
  }
}

TEST(RaysTest, AMirrorIsHitByTheEngineThatMovesIt) {
  World world;
  Kinematics2d other;
  const Row mirror = world.addToSpace(discModel(0.5, 1.0), flatPose(5.0, 5.0));
  world.space.mover[mirror] = &other;
  test::carryOut(world.space);
  world.engine.add(world.space, mirror, Role::kMirror);
  EXPECT_EQ(world.castRay({3.0, 5.0, 0.5}, {7.0, 5.0, 0.5}).row, kNoRow);
  // no engine moves it, so this engine reports the hit
  world.space.mover[mirror] = nullptr;
  world.step();
  EXPECT_EQ(world.castRay({3.0, 5.0, 0.5}, {7.0, 5.0, 0.5}).row, mirror);
}

TEST(RaysTest, ARobotOnTheMoveSeesWhatComesNear) {
  // known distances save searches for neighbours; they must not hide hits
  World world;
  const Row mover = world.addFootbot(flatPose(1.0, 5.0));
  const Row other = world.addRobot(discModel(0.1, 0.3), flatPose(3.0, 5.0, M_PI));
  world.addBlock({4.0, 4.0, 0.1}, {2.0, 5.0, 0.75});  // a table top
  world.drive(mover, 0.1);
  world.drive(other, 0.25);
  for (int tick = 0; tick < 100; ++tick) {
    world.step();
    const Vector3d from = world.pose(mover).position + Vector3d(0.0, 0.0, 0.1);
    const double gap = world.pose(other).position.x() - 0.1 - from.x();
    const RayHit hit = world.castRay(from, from + Vector3d(0.3, 0.0, 0.0), mover);
    EXPECT_EQ(hit.row, gap < 0.3 ? other : kNoRow) << gap;
    EXPECT_NEAR(hit.fraction, std::min(1.0, gap / 0.3), 1e-12);
    EXPECT_NE(world.castRay(from, from + Vector3d(0.0, 0.0, 0.7), mover).row, kNoRow);
  }
}

/// Compares entities in an engine with the same entities in none, for which the space tests rays itself, with other
/// code.
class RandomRaysTest : public testing::TestWithParam<const char*> {
 protected:
  void fill(World& world, World& reference, const std::string& axis) {
    std::uniform_real_distribution<double> place(0.3, 2.7);
    std::uniform_real_distribution<double> angle(-M_PI, M_PI);
    Eigen::Quaterniond upright = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), Vector3d::Unit(axis[0] - 'x'));
    for (int i = 0; i < 60; ++i) {
      Pose pose;
      pose.position = {place(random_), place(random_), place(random_)};
      pose.orientation = Eigen::AngleAxisd(angle(random_), Vector3d::Unit(axis[0] - 'x')) * upright;
      std::shared_ptr<const EntityModel> model = footbotModel();
      if (i % 3 == 1) {
        model = blockModel({0.1 + 0.02 * i, 0.3, 0.2});
      } else if (i % 3 == 2) {
        model = cylindricPreyModel(0.1, 0.3);
      }
      world.add(model, pose);
      reference.space.entities_without_engine.place(reference.space.entities, reference.addToSpace(model, pose));
    }
  }

  std::mt19937 random_{7};
};

TEST_P(RandomRaysTest, TenThousandRaysHitWhatTheSolidsSay) {
  World world({3.0, 3.0, 3.0}, 1, GetParam());
  World reference({3.0, 3.0, 3.0}, 1, GetParam());
  fill(world, reference, GetParam());
  std::uniform_real_distribution<double> place(0.0, 3.0);
  int hit_count = 0;
  for (int i = 0; i < 10000; ++i) {
    const Vector3d from(place(random_), place(random_), place(random_));
    const Vector3d to(place(random_), place(random_), place(random_));
    const Row ignored{i % 61 - 1};
    const RayHit hit = world.castRay(from, to, ignored);
    const RayHit expected = reference.castRay(from, to, ignored);
    ASSERT_NEAR(hit.fraction, expected.fraction, 1e-9) << i;
    ASSERT_TRUE(hit.row == expected.row || hit.fraction == 0.0) << i;  // inside several, either is correct
    hit_count += hit.row != kNoRow ? 1 : 0;
  }
  EXPECT_GT(hit_count, 2000);
  EXPECT_LT(hit_count, 9000);
}

INSTANTIATE_TEST_SUITE_P(Axes, RandomRaysTest, testing::Values("x", "y", "z"));

TEST_P(RandomRaysTest, ABundleHitsWhatItsRaysHitAlone) {
  World world({3.0, 3.0, 3.0}, 1, GetParam());
  World unused({3.0, 3.0, 3.0}, 1, GetParam());
  fill(world, unused, GetParam());
  std::uniform_real_distribution<double> place(0.0, 3.0);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int i = 0; i < 200; ++i) {
    RayBundle bundle;
    bundle.centre = {place(random_), place(random_), place(random_)};
    bundle.radius = 0.5;
    std::vector<Segment> segments(70);  // more than the engine handles at once
    for (Segment& segment : segments) {
      const Vector3d a(unit(random_), unit(random_), unit(random_));
      const Vector3d b(unit(random_), unit(random_), unit(random_));
      segment = {bundle.centre + 0.28 * a, bundle.centre + 0.28 * b};
    }
    std::vector<RayHit> hits(segments.size());
    bundle.segments = segments;
    world.space.raycast(bundle, hits);
    for (std::size_t k = 0; k < segments.size(); ++k) {
      const RayHit alone = world.space.castRay(segments[k]);
      ASSERT_EQ(hits[k].fraction, alone.fraction);
      ASSERT_EQ(hits[k].row, alone.row);
    }
  }
}

/// Rays around a point, in the plane of figure 3.9.
std::vector<Segment> ringAround(const Vector3d& centre, double length) {
  std::vector<Segment> segments(24);
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const double angle = 2.0 * M_PI * static_cast<double>(k) / static_cast<double>(segments.size());
    segments[k] = {centre, centre + length * Vector3d(std::cos(angle), std::sin(angle), 0.1)};
  }
  return segments;
}

bool passesBy(const Segment& segment, const Obstacles& obstacles) {
  FlatRays<1> ray;
  ray.resize(1);
  ray.set(0, segment.from.head<2>(), (segment.to - segment.from).head<2>());
  ray.measure();
  return obstacles.areAnywhere() ||
         std::any_of(obstacles.circles().begin(), obstacles.circles().end(),
                     [&](const auto& circle) { return ray.nearPoint(circle.centre, circle.radius) != 0; }) ||
         std::any_of(obstacles.boxes().begin(), obstacles.boxes().end(), [&](const auto& box) {
           return ray.nearBox({box.min, box.max}) != 0;
         });
}

/// Expects that a ray hits an exactly circular obstacle where it enters its circle. @return number of exact circles
int expectExactCircles(const Space& space, const Segment& segment, const Obstacles& obstacles) {
  FlatRays<1> ray;
  ray.resize(1);
  ray.set(0, segment.from.head<2>(), (segment.to - segment.from).head<2>());
  int exact = 0;
  for (const Obstacles::Circle& circle : obstacles.circles()) {
    if (circle.is_exact) {
      RayHit hit;
      space.castRayAt(circle.solid, segment, hit);
      EXPECT_NEAR(ray.entryInto(circle.centre, circle.radius, 0), hit.fraction, 1e-12);
      ++exact;
    }
  }
  return exact;
}

/// Numbers of rays that hit, of rays that pass by an obstacle, and of exact circles; expects that every ray that hits
/// passes by an obstacle.
std::array<int, 3> hitsPassesAndExactCircles(const Space& space, const Vector3d& centre) {
  constexpr double kLength = 0.15;
  const std::vector<Segment> segments = ringAround(centre, kLength);
  RayBundle bundle;
  bundle.segments = segments;
  bundle.centre = centre;
  bundle.radius = 1.01 * kLength;
  bundle.lowest = centre.z();
  bundle.highest = centre.z() + 0.1001 * kLength;
  std::vector<RayHit> hits(segments.size());
  space.raycast(bundle, hits);
  const Obstacles obstacles = space.findObstacles(bundle);
  EXPECT_TRUE(obstacles.isEmpty() || space.mayHit(bundle));
  std::array<int, 3> counts{0, 0, 0};
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const bool passes = passesBy(segments[k], obstacles);
    EXPECT_TRUE(passes || !hits[k].isHit()) << "ray " << k << " at " << centre.transpose();
    counts[0] += hits[k].isHit() ? 1 : 0;
    counts[1] += passes ? 1 : 0;
    counts[2] += expectExactCircles(space, segments[k], obstacles);
  }
  return counts;
}

TEST_P(RandomRaysTest, WhatABundleHitsIsAmongItsObstacles) {
  World world({3.0, 3.0, 3.0}, 1, GetParam());
  World reference({3.0, 3.0, 3.0}, 1, GetParam());
  fill(world, reference, GetParam());
  std::uniform_real_distribution<double> place(0.0, 3.0);
  constexpr int kRings = 2000;
  for (const Space* space : {&world.space, &reference.space}) {
    std::array<int, 3> sum{0, 0, 0};
    for (int i = 0; i < kRings; ++i) {
      const auto counts = hitsPassesAndExactCircles(*space, {place(random_), place(random_), place(random_)});
      std::transform(counts.begin(), counts.end(), sum.begin(), sum.begin(), std::plus<>());
    }
    EXPECT_GT(sum[0], kRings);
    // seen from above, a wall or a robot leaves part of a ring free
    const bool is_seen_from_above = GetParam() == std::string("z") || space == &reference.space;
    EXPECT_TRUE(sum[1] < 18 * kRings || !is_seen_from_above) << sum[1];
    EXPECT_EQ(sum[2] > 100, is_seen_from_above && space != &reference.space) << sum[2];
  }
}

}  // namespace
}  // namespace swarmanoid::kinematics2d
