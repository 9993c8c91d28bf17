// Rays and occlusion across engines (thesis 3.4): a ground plane, a sky plane one metre above it, and entities in
// neither.
#include <gtest/gtest.h>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid::test {
namespace {

using Eigen::Vector3d;

std::string entity(const std::string& tag, const std::string& id, const std::string& position,
                   const std::string& more = "") {
  return "<" + tag + " id=\"" + id + "\"><position>" + position + "</position><orientation>0,0,0</orientation>" + more +
         "</" + tag + ">";
}

/// A wall in the ground engine, a footbot, a prey, an eyebot in the sky engine, a block in no engine, a pillar in both.
std::unique_ptr<Simulation> world() {
  loadBuiltInPlugins();
  const std::string entities =
      entity("block", "wall", "5,2,0.25", "<size>0.1,2,0.5</size>") + entity("footbot", "fb", "1,5,0") +
      entity("cylindric_prey", "prey", "3,5,0", "<radius>0.1</radius><height>0.2</height>") +
      entity("eyebot", "eb", "5,5,1") + entity("block", "free", "8,5,0.1", "<size>0.2,0.2,0.2</size>") +
      entity("block", "pillar", "5,8,1", "<size>0.2,0.2,2</size>");
  auto simulation = std::make_unique<Simulation>(parseExperiment(
      "<ahss-config><framework><clocktick>100</clocktick><maxclock>10</maxclock></framework>"
      "<arena size=\"10,10,3\" optimization=\"3D\">" +
          entities +
          "</arena><engines><kinematics2d id=\"ground\"/><kinematics2d id=\"sky\"><distance>1</distance>"
          "</kinematics2d></engines><arena_physics><engine id=\"ground\"><entity id=\"wall\"/>"
          "<entity id=\"fb\"/><entity id=\"prey\"/><entity id=\"pillar\"/></engine>"
          "<engine id=\"sky\"><entity id=\"eb\"/><entity id=\"pillar\"/></engine></arena_physics>"
          "</ahss-config>",
      "occlusion.xml"));
  simulation->start();
  return simulation;
}

class OcclusionTest : public testing::Test {
 protected:
  Row row(const std::string& name) const { return space.entities.find(name); }

  /// Name of the closest entity on a ray, and its distance from the start [m]; "" for none.
  std::pair<std::string, double> closestHit(const Vector3d& from, const Vector3d& to, Row ignored = kNoRow,
                                            Row also_ignored = kNoRow) const {
    const RayHit hit = space.castRay({from, to}, ignored, also_ignored);
    return {hit.row == kNoRow ? "" : space.entities.name[hit.row], hit.fraction * (to - from).norm()};
  }

  void expectHit(const std::string& name, double distance, const Vector3d& from, const Vector3d& to) const {
    EXPECT_EQ(closestHit(from, to).first, name);
    EXPECT_NEAR(closestHit(from, to).second, distance, 1e-9);
  }

  std::unique_ptr<Simulation> simulation = world();
  const Space& space = simulation->space();
};

TEST_F(OcclusionTest, HitsWhatStandsInEachEngineAndInNone) {
  expectHit("wall", 1.95, {3.0, 2.0, 0.3}, {7.0, 2.0, 0.3});
  expectHit("fb", 0.915, {0.0, 5.0, 0.1}, {1.0, 5.0, 0.1});
  expectHit("prey", 0.9, {2.0, 5.0, 0.1}, {4.0, 5.0, 0.1});
  expectHit("eb", 1.75, {3.0, 5.0, 1.2}, {7.0, 5.0, 1.2});
  expectHit("free", 0.9, {7.0, 5.0, 0.1}, {9.0, 5.0, 0.1});
  expectHit("pillar", 1.9, {3.0, 8.0, 0.5}, {7.0, 8.0, 0.5});
}

TEST_F(OcclusionTest, TheNearestIsHitWhicheverEngineItIsIn) {
  // from the footbot to the block in no engine the prey is hit first; from the other end the block is
  expectHit("prey", 1.7, {1.2, 5.0, 0.1}, {9.0, 5.0, 0.1});
  expectHit("free", 0.9, {9.0, 5.0, 0.1}, {1.2, 5.0, 0.1});
  // down through the eyebot's body, which ends at z = 1, to no other body
  expectHit("eb", 3.0 - 1.54, {5.0, 5.0, 3.0}, {5.0, 5.0, 0.0});
}

TEST_F(OcclusionTest, NothingIsHitOverUnderBesideAndShortOfThings) {
  EXPECT_EQ(closestHit({3.0, 2.0, 0.51}, {7.0, 2.0, 0.51}).first, "") << "over the wall";
  EXPECT_EQ(closestHit({3.0, 3.01, 0.3}, {7.0, 3.01, 0.3}).first, "") << "past its end";
  EXPECT_EQ(closestHit({3.0, 2.0, 0.3}, {4.949, 2.0, 0.3}).first, "") << "short of it";
  EXPECT_EQ(closestHit({3.0, 5.0, 0.9}, {7.0, 5.0, 0.9}).first, "") << "under the eyebot";
}

TEST_F(OcclusionTest, WhatIsInTwoEnginesIsOneThing) {
  EXPECT_EQ(closestHit({3.0, 8.0, 0.5}, {7.0, 8.0, 0.5}, row("pillar")).first, "") << "ignored in both engines";
  EXPECT_EQ(closestHit({3.0, 8.0, 1.5}, {7.0, 8.0, 1.5}, kNoRow, row("pillar")).first, "");
}

TEST_F(OcclusionTest, BothEndsAreLookedThroughAndNothingElse) {
  const Vector3d footbot(1.0, 5.0, 0.1);
  const Vector3d prey(3.0, 5.0, 0.1);
  const Vector3d block(8.0, 5.0, 0.1);
  EXPECT_FALSE(space.isOccluded({footbot, prey}, row("fb"), row("prey")));
  EXPECT_TRUE(space.isOccluded({footbot, prey}, row("fb"), kNoRow)) << "its own surface is in the way";
  EXPECT_TRUE(space.isOccluded({footbot, prey}, kNoRow, row("prey")));
  EXPECT_TRUE(space.isOccluded({footbot, block}, row("fb"), row("free"))) << "the prey is between";
  EXPECT_TRUE(space.isOccluded({block, footbot}, row("free"), row("fb")));
}

TEST_F(OcclusionTest, FollowsWhatIsMovedAndForgetsWhatIsRemoved) {
  const Vector3d from(2.0, 5.0, 0.1);
  const Vector3d to(4.0, 5.0, 0.1);
  simulation->apply(MoveEntity{"prey", {{3.5, 5.0, 0.0}, Eigen::Quaterniond::Identity()}});
  expectHit("prey", 1.4, from, to);
  simulation->apply(MoveEntity{"free", {{2.5, 5.0, 0.1}, Eigen::Quaterniond::Identity()}});
  expectHit("free", 0.4, from, to);
  simulation->apply(DeleteEntity{"free"});
  simulation->apply(DeleteEntity{"prey"});
  EXPECT_EQ(closestHit(from, to).first, "");
}

TEST_F(OcclusionTest, WhoeverCouldBeHitIsAnnouncedAndNobodyFarOff) {
  const auto mayHit = [&](const Vector3d& centre, double radius, Row ignored = kNoRow, Row also_ignored = kNoRow) {
    RayBundle rays;
    rays.centre = centre;
    rays.radius = radius;
    rays.ignored = ignored;
    rays.also_ignored = also_ignored;
    return space.mayHit(rays);
  };
  int hit_count = 0;
  for (int i = 0; i < 4000; ++i) {
    // all over the arena, with incommensurable steps
    const Vector3d centre(std::fmod(i * 0.377, 10.0), std::fmod(i * 0.731, 10.0), std::fmod(i * 0.113, 1.0));
    const double radius = 0.05 + std::fmod(i * 0.0717, 0.6);
    const Vector3d way = radius * Vector3d(std::cos(i), std::sin(i), 0.0);
    if (space.castRay({centre - way, centre + way}).row != kNoRow) {
      ++hit_count;
      ASSERT_TRUE(mayHit(centre, radius)) << centre.transpose() << " radius " << radius;
    }
  }
  EXPECT_GT(hit_count, 50);
  EXPECT_FALSE(mayHit({8.0, 1.5, 0.1}, 1.0));
  EXPECT_TRUE(mayHit({3.0, 5.0, 0.1}, 0.5));
  EXPECT_FALSE(mayHit({3.0, 5.0, 0.1}, 0.5, row("prey")));
  EXPECT_FALSE(mayHit({8.0, 5.0, 0.1}, 0.5, kNoRow, row("free")));
}

TEST_F(OcclusionTest, ABundleHitsWhatItsRaysHitOneByOne) {
  std::vector<Segment> segments;
  for (int i = 0; i < 360; ++i) {
    const double angle = i * M_PI / 180.0;
    segments.push_back({{4.0, 5.0, 0.15}, {4.0 + 5.0 * std::cos(angle), 5.0 + 5.0 * std::sin(angle), 0.12}});
  }
  RayBundle bundle;
  bundle.segments = segments;
  bundle.centre = {4.0, 5.0, 0.15};
  bundle.radius = 5.1;
  bundle.ignored = row("prey");
  std::vector<RayHit> hits(segments.size());
  space.raycast(bundle, hits);
  std::size_t hit_count = 0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const RayHit alone = space.castRay(segments[i], row("prey"));
    EXPECT_EQ(hits[i].row, alone.row) << i << " degrees";
    EXPECT_DOUBLE_EQ(hits[i].fraction, alone.fraction) << i << " degrees";
    hit_count += alone.row != kNoRow ? 1 : 0;
  }
  EXPECT_GT(hit_count, 20U);
}

}  // namespace
}  // namespace swarmanoid::test
