// The rules `area_coverage` and `region_count`: squares visited by robots, and counts of entities in a region.
#include "measured_run.hpp"

namespace swarmanoid::test {
namespace {

std::string coverage(const std::string& values) {
  return "<area_coverage id='r'>\n<robots>fb_</robots>\n" + values + "\n</area_coverage>";
}

std::string count(const std::string& values) {
  return "<region_count id='r'>\n<robots>fb_</robots>\n" + values + "\n</region_count>";
}

/// 3.7 m x 2.2 m in squares of 0.7 m: 5 x 3 complete squares; the remaining strips do not count.
TEST(AreaCoverageTest, CountsSquaresThatAreWholeAndVisited) {
  MeasuredRun run(coverage("<minimum>1.3, 2.1</minimum><maximum>5, 4.3</maximum><cell>0.7</cell>"),
                  {{1.35, 2.15}, {1.9, 2.7}, {0.9, 3.0}, {4.9, 4.25}});
  EXPECT_NEAR(run.metric("share"), 1.0 / 15.0, 1e-15) << "two in one square, one outside, one in a strip";
  EXPECT_NEAR(run.metric("area"), 0.49, 1e-15);
  run.put("fb_1", {2.05, 2.15});
  run.put("fb_3", {4.7, 4.15});
  run.tick();
  EXPECT_NEAR(run.metric("share"), 3.0 / 15.0, 1e-15);
  run.put("fb_1", {1.35, 2.15});
  run.tick();
  EXPECT_NEAR(run.metric("share"), 3.0 / 15.0, 1e-15) << "what was visited stays visited, and counts once";
  run.simulation().reset();
  EXPECT_NEAR(run.metric("share"), 1.0 / 15.0, 1e-15);
}

TEST(AreaCoverageTest, IsOfTheArenaIfNothingElseIsSaid) {
  MeasuredRun run(coverage("<cell>0.1</cell>"), {{0.0, 0.0}, {9.95, 9.95}});
  EXPECT_EQ(run.metric("share"), 2.0 / 10000.0) << "100 x 100, whatever 10 / 0.1 is rounded to";
}

TEST(AreaCoverageTest, WhatIsWrongIsNamedWithItsLine) {
  EXPECT_EQ(refusalOfRule(coverage("<maximum>10, 10.5</maximum>")),
            "run.xml:9: maximum: found '10, 10.5', allowed: in the arena, from 0, 0 to 10, 10");
  EXPECT_EQ(refusalOfRule(coverage("<minimum>3, 3</minimum>\n<maximum>5, 3.5</maximum>\n<cell>0.75</cell>")),
            "run.xml:11: cell: found '0.75', allowed: at most the shorter side of the area, 0.5");
  EXPECT_EQ(refusalOfRule(coverage("<cell>0.001</cell>")),
            "run.xml:9: cell: found '0.001', allowed: at least 0.0031622776601683794, for ten million squares");
}

TEST(RegionCountTest, CountsRobotsNowInTheMeanAndAtMost) {
  MeasuredRun run(count("<minimum>1.3, 2.1, -0.1</minimum><maximum>4, 4.3, 0.1</maximum>"),
                  {{1.3, 2.1}, {4.01, 3.0}, {2.0, 3.3}});
  EXPECT_EQ(run.metric("inside"), 2.0) << "who stands on the border is in it";
  run.put("fb_2", {3.9, 3.0});
  run.tick();
  EXPECT_EQ(run.metric("inside"), 3.0);
  run.put("fb_1", {8.0, 8.0});
  run.put("fb_2", {8.5, 8.0});
  run.tick();
  EXPECT_EQ(run.metric("inside"), 1.0);
  EXPECT_EQ(run.metric("most"), 3.0);
  EXPECT_NEAR(run.metric("mean"), (2.0 + 3.0 + 1.0) / 3.0, 1e-15);
  EXPECT_EQ(run.simulation().success(), std::nullopt) << "it is not judged";
}

TEST(RegionCountTest, EnoughObjectsAreASuccessAndMayEndTheRun) {
  const std::string region = "<minimum>1.3, 2.1, -0.1</minimum><maximum>4, 4.3, 0.1</maximum><objects>prey</objects>";
  const std::string preys =
      "<cylindric_prey id='prey_1'><position>2,3,0</position><orientation>0,0,0</orientation><radius>0.06</radius>"
      "<height>0.1</height></cylindric_prey><cylindric_prey id='prey_2'><position>7,3,0</position>"
      "<orientation>0,0,0</orientation><radius>0.06</radius><height>0.1</height></cylindric_prey>";
  for (const bool ends : {false, true}) {
    MeasuredRun run(count(region + "<enough>2</enough><ends>" + (ends ? "true" : "false") + "</ends>"),
                    {{2.0, 2.5}, {2.0, 3.5}}, preys);
    run.tick();
    EXPECT_EQ(run.metric("inside"), 1.0) << "robots do not count";
    EXPECT_EQ(run.simulation().success(), false);
    EXPECT_FALSE(run.simulation().isFinished());
    run.put("prey_2", {3.1, 2.9});
    run.tick();
    EXPECT_EQ(run.simulation().success(), true);
    EXPECT_EQ(run.simulation().isFinished(), ends);
  }
}

TEST(RegionCountTest, WhatIsWrongIsNamedWithItsLine) {
  EXPECT_EQ(refusalOfRule(count("<minimum>1, 2, 0</minimum>\n<maximum>1, 1.9, 0</maximum>")),
            "run.xml:10: maximum: found '1, 1.9, 0', allowed: nothing below minimum, '1, 2, 0'");
  EXPECT_EQ(refusalOfRule(count("<minimum>1, 2, 0</minimum>\n<maximum>1, 2, 0</maximum>\n<ends>true</ends>")),
            "run.xml:11: ends: found 'true', allowed: only with enough above 0");
}

TEST(PresenceTest, ASteadyTickAllocatesNothing) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  const std::string region = "<minimum>1, 2, 0</minimum><maximum>3, 4, 0</maximum>";
  for (const std::string& rule : {coverage(""), count(region), count(region + "<objects>prey</objects>")}) {
    MeasuredRun run(rule, {{1.0, 1.0}, {1.3, 1.0}, {4.0, 1.0}});
    EXPECT_EQ(allocationsOfATick(run), 0) << rule;
  }
}

}  // namespace
}  // namespace swarmanoid::test
