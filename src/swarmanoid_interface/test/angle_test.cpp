// Expected values are remainders of whole turns of twice the double nearest to pi, from exact fractions.
#include "swarmanoid_interface/angle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "swarmanoid_interface/arctangent.hpp"

namespace swarmanoid {
namespace {

constexpr double kBeyondHalfATurn = 3.1415926535897936;  // the double after M_PI

TEST(AngleTest, AnAngleIsWrappedToTheBit) {
  for (double (*wrap)(double) : {wrapAngle, wrapTurn}) {
    EXPECT_EQ(wrap(1.25), 1.25);
    EXPECT_EQ(wrap(3.5), -2.7831853071795862);
    EXPECT_EQ(wrap(-3.5), 2.7831853071795862);
    EXPECT_EQ(wrap(7.0), 0.7168146928204138);
    EXPECT_EQ(wrap(100.0), -0.5309649148733797);    // 16 turns
    EXPECT_EQ(wrap(-1000.5), -1.4735361584457891);  // 159 turns back
    EXPECT_EQ(wrap(1e6), -0.3575641670467533);      // 159,155 turns
    EXPECT_EQ(wrap(63.08185307179586), 0.25);       // 10 turns and a quarter of a radian
    EXPECT_EQ(wrap(kBeyondHalfATurn), -3.1415926535897927);
    EXPECT_EQ(wrap(-kBeyondHalfATurn), 3.1415926535897927);
    EXPECT_TRUE(std::signbit(wrap(-0.0)));
  }
}

TEST(AngleTest, HalfATurnKeepsItsSignAsAnAngle) {
  EXPECT_EQ(wrapAngle(M_PI), M_PI);
  EXPECT_EQ(wrapAngle(-M_PI), -M_PI);
  EXPECT_EQ(wrapAngle(3.0 * M_PI), -M_PI);  // halfway, where the remainder goes to an even number of turns
  EXPECT_EQ(wrapAngle(5.0 * M_PI), M_PI);
}

TEST(AngleTest, HalfATurnIsPositiveAsATurn) {
  EXPECT_EQ(wrapTurn(M_PI), M_PI);
  EXPECT_EQ(wrapTurn(-M_PI), M_PI);
  EXPECT_EQ(wrapTurn(3.0 * M_PI), M_PI);
  EXPECT_EQ(wrapTurn(-5.0 * M_PI), M_PI);
}

TEST(AngleTest, WhatIsNotFiniteIsNoAngle) {
  for (double (*wrap)(double) : {wrapAngle, wrapTurn}) {
    EXPECT_TRUE(std::isnan(wrap(std::numeric_limits<double>::infinity())));
    EXPECT_TRUE(std::isnan(wrap(std::numeric_limits<double>::quiet_NaN())));
  }
}

TEST(ArctangentTest, IsTheLibrarysWithinSinglePrecision) {
  // each direction at lengths from 1e-6 to 1e6: 1.3e5 vectors on both sides of both diagonals and both axes
  double worst = 0.0;
  for (int i = 0; i < 20011; ++i) {
    const double angle = -M_PI + 2.0 * M_PI * (i + 0.37) / 20011.0;
    for (double length = 1e-6; length < 2e6; length *= 100.0) {
      const auto y = static_cast<float>(length * std::sin(angle));
      const auto x = static_cast<float>(length * std::cos(angle));
      const double expected = std::atan2(static_cast<double>(y), static_cast<double>(x));
      worst = std::max(worst, std::abs(static_cast<double>(arctangent(y, x)) - expected));
    }
  }
  EXPECT_LT(worst, 4e-7);
}

TEST(ArctangentTest, IsExactAlongTheAxes) {
  EXPECT_EQ(arctangent(0.0F, 3.0F), 0.0F);
  EXPECT_EQ(arctangent(0.7F, 0.0F), static_cast<float>(M_PI / 2.0));
  EXPECT_EQ(arctangent(-0.7F, 0.0F), static_cast<float>(-M_PI / 2.0));
  EXPECT_EQ(arctangent(0.0F, -0.2F), static_cast<float>(M_PI));
  EXPECT_EQ(arctangent(-0.0F, -0.2F), static_cast<float>(-M_PI));
  EXPECT_EQ(arctangent(0.0F, 0.0F), 0.0F);
}

}  // namespace
}  // namespace swarmanoid
