// The rule `distance_to`: distances of robots at known positions to positions, lines and the nearest entity of a type.
#include <algorithm>
#include <random>

#include "measured_run.hpp"

namespace swarmanoid::test {
namespace {

constexpr double kTolerance = 1e-12;

std::string rule(const std::string& to) {
  return "<distance_to id='r'>\n<robots>fb_</robots>\n<to>" + to + "</to>\n</distance_to>";
}

std::string light(const std::string& id, double x, double y) {
  return "<light id='" + id + "'><position>" + numberText(x) + "," + numberText(y) +
         ",1.7</position><orientation>0,0,0</orientation></light>";
}

TEST(DistanceToTest, OfAPlaceIsSeenFromAbove) {
  MeasuredRun run(rule("3.3, 1.9"), {{1.2, 0.7}, {4.1, 2.8}, {8.9, 7.3}});
  const double a = std::hypot(2.1, 1.2);
  const double b = std::hypot(0.8, 0.9);
  const double c = std::hypot(5.6, 5.4);
  EXPECT_NEAR(run.metric("mean"), (a + b + c) / 3.0, kTolerance) << "before the first tick, too";
  EXPECT_NEAR(run.metric("least"), b, kTolerance);
  EXPECT_NEAR(run.metric("greatest"), c, kTolerance);
  run.put("fb_3", {3.3, 1.9});
  run.tick();
  EXPECT_EQ(run.metric("least"), 0.0);
  EXPECT_NEAR(run.metric("greatest"), a, kTolerance);
}

/// Robots beside the line have their perpendicular distance, robots beyond an end the distance from that end.
TEST(DistanceToTest, OfALineIsThatOfItsNearestPoint) {
  const double turn = 0.43;  // rad
  const Eigen::Vector2d along(std::cos(turn), std::sin(turn));
  const Eigen::Vector2d across(-along.y(), along.x());
  const Eigen::Vector2d start(2.3, 3.1);
  const Eigen::Vector2d end = start + 4.2 * along;
  const auto at = [&](double way, double beside) {
    const Eigen::Vector2d place = start + way * along + beside * across;
    return Stand{place.x(), place.y(), 0.0};
  };
  const MeasuredRun run(
      rule(numberText(start.x()) + "," + numberText(start.y()) + "," + numberText(end.x()) + "," + numberText(end.y())),
      {at(1.7, 0.37), at(3.9, -1.4), at(-0.9, 0.6), at(4.2 + 0.5, -1.1)});
  const double beyond_start = std::hypot(0.9, 0.6);
  const double beyond_end = std::hypot(0.5, 1.1);
  EXPECT_NEAR(run.metric("least"), 0.37, kTolerance);
  EXPECT_NEAR(run.metric("greatest"), 1.4, kTolerance);
  EXPECT_NEAR(run.metric("mean"), (0.37 + 1.4 + beyond_start + beyond_end) / 4.0, kTolerance);
}

TEST(DistanceToTest, OfAKindIsThatOfTheNearestThatThereIsNow) {
  MeasuredRun run(rule("light"), {{1.2, 0.7}, {6.1, 5.2}}, light("west", 0.4, 2.6) + light("east", 7.0, 4.1));
  const double first = std::hypot(0.8, 1.9);
  const double second = std::hypot(0.9, 1.1);
  EXPECT_NEAR(run.metric("mean"), (first + second) / 2.0, kTolerance);
  run.remove("west");
  run.tick();
  EXPECT_NEAR(run.metric("greatest"), std::hypot(5.8, 3.4), kTolerance);
  run.remove("east");
  run.tick();
  EXPECT_NEAR(run.metric("greatest"), std::hypot(5.8, 3.4), kTolerance) << "there is none: the last values stay";
}

TEST(DistanceToTest, ARobotIsNotNearToItself) {
  const MeasuredRun run(rule("footbot"), {{1.2, 0.7}, {4.1, 2.8}});
  EXPECT_NEAR(run.metric("least"), std::hypot(2.9, 2.1), kTolerance);
  EXPECT_NEAR(run.metric("greatest"), std::hypot(2.9, 2.1), kTolerance);
}

/// Many and few, spread and crowded, one alone: the index finds the nearest robot in each case.
TEST(DistanceToTest, TheIndexFindsWhatALookAtAllFinds) {
  std::mt19937 random(20260412);
  for (const std::size_t count : {5U, 40U, 400U}) {
    std::uniform_real_distribution<double> place(0.0, 10.0);
    std::normal_distribution<double> crowd(3.0, 0.4);
    std::vector<Stand> stands;
    for (std::size_t i = 0; i + 1 < count; ++i) {
      stands.push_back(i % 3 == 0 ? Stand{place(random), place(random), 0.0}
                                  : Stand{std::abs(crowd(random)), std::abs(crowd(random)), 0.0});
    }
    stands.push_back({9.9, 0.1, 0.0});
    MeasuredRun run(rule("footbot"), stands);
    const auto expect = [&] {
      std::vector<Stand> all = stands;
      all.push_back({9.3, 9.1, 0.0});  // not counted, but a possible nearest robot
      std::vector<double> nearest(stands.size(), 1e9);
      double sum = 0.0;
      for (std::size_t i = 0; i < stands.size(); ++i) {
        for (std::size_t k = 0; k < all.size(); ++k) {
          nearest[i] = k == i ? nearest[i] : std::min(nearest[i], std::hypot(all[k].x - all[i].x, all[k].y - all[i].y));
        }
        sum += nearest[i];
      }
      EXPECT_NEAR(run.metric("mean"), sum / static_cast<double>(count), kTolerance) << count;
      EXPECT_NEAR(run.metric("greatest"), *std::max_element(nearest.begin(), nearest.end()), kTolerance) << count;
      EXPECT_NEAR(run.metric("least"), *std::min_element(nearest.begin(), nearest.end()), kTolerance) << count;
    };
    expect();
    for (std::size_t i = 0; i < count; i += 2) {
      stands[i] = {place(random), place(random), 0.0};
      run.put("fb_" + std::to_string(i + 1), stands[i]);
    }
    run.tick();
    expect();
  }
}

TEST(DistanceToTest, WhatIsWrongIsNamedWithItsLine) {
  const std::string line = "run.xml:9: ";  // of <to>
  EXPECT_EQ(refusalOfRule(rule("3")), line + "to: found '3', allowed: two numbers, four numbers, or an entity type");
  EXPECT_EQ(refusalOfRule(rule("1, 2, 3")),
            line + "to: found '1, 2, 3', allowed: two numbers, four numbers, or an entity type");
  EXPECT_EQ(refusalOfRule(rule("")), line + "to: found '', allowed: two numbers, four numbers, or an entity type");
  EXPECT_EQ(refusalOfRule(rule("1, x")),
            line + "to: found '1, x', allowed: 2 numbers separated by commas, each from -10000 to 10000");
  EXPECT_EQ(refusalOfRule(rule("lihgt"))
                .rfind(line + "to: found the entity type 'lihgt', allowed: block, ceiling_perch, ", 0),
            0U);
  EXPECT_NE(refusalOfRule(rule("lihgt")).find("; did you mean 'light'?"), std::string::npos);
}

TEST(DistanceToTest, ASteadyTickAllocatesNothing) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  std::vector<Stand> many;
  for (int i = 0; i < 40; ++i) {
    many.push_back({0.5 + 0.23 * i, 0.5 + 0.2 * (i * 7 % 40), 0.0});
  }
  for (const char* to : {"1, 2", "1, 2, 3, 4", "footbot", "light"}) {
    MeasuredRun run(rule(to), many, light("lamp", 3.0, 3.0));
    EXPECT_EQ(allocationsOfATick(run), 0) << to;
  }
}

}  // namespace
}  // namespace swarmanoid::test
