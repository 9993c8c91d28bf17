#include "swarmanoid_space/rays/line_part.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>

namespace swarmanoid {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

void expectPart(const LinePart& part, double from, double to) {
  EXPECT_EQ(part.from, from);
  EXPECT_EQ(part.to, to);
  EXPECT_EQ(part.isEmpty(), from > to);
}

TEST(LinePartTest, ASlabCutsEitherEnd) {
  LinePart part;
  part.clipToSlab(0.0, 8.0, 2.0, 4.0);
  expectPart(part, 0.25, 0.5);
  part = {};
  part.clipToSlab(8.0, -8.0, 2.0, 4.0);  // opposite direction
  expectPart(part, 0.5, 0.75);
  part = {};
  part.clipToSlab(3.0, 8.0, 2.0, 4.0);  // from within
  expectPart(part, 0.0, 0.125);
  part = LinePart::whole();
  part.clipToSlab(3.0, 8.0, 2.0, 4.0);  // also the part before the start
  expectPart(part, -0.125, 0.125);
}

TEST(LinePartTest, WhatRunsAlongASlabIsInsideOrNot) {
  for (const double inside : {2.0, 3.0, 4.0}) {
    LinePart part;
    part.clipToSlab(inside, 0.0, 2.0, 4.0);
    expectPart(part, 0.0, 1.0);
  }
  for (const double outside : {1.75, 4.25}) {
    LinePart part = LinePart::whole();
    part.clipToSlab(outside, 0.0, 2.0, 4.0);
    EXPECT_TRUE(part.isEmpty());
    part.clipToSlab(3.0, 1.0, 2.0, 4.0);
    EXPECT_TRUE(part.isEmpty()) << "what is empty stays so";
  }
}

TEST(LinePartTest, ARoundIsEnteredAndLeft) {
  // at a height of 3 a circle of radius 5 reaches 4 to either side
  LinePart part;
  part.clipToRound(Vector2d(-8.0, 3.0), Vector2d(16.0, 0.0), 5.0);
  expectPart(part, 0.25, 0.75);
  part = LinePart::whole();
  part.clipToRound(Vector3d(0.0, 3.0, 0.0), Vector3d(0.0, 0.0, 2.0), 5.0);
  expectPart(part, -2.0, 2.0);
  part = {};
  part.clipToRound(Vector2d(-8.0, 5.5), Vector2d(16.0, 0.0), 5.0);  // passes by
  EXPECT_TRUE(part.isEmpty());
}

TEST(LinePartTest, APointIsInARoundOrNot) {
  LinePart part;
  part.clipToRound(Vector2d(3.0, 4.0), Vector2d(0.0, 0.0), 5.0);
  expectPart(part, 0.0, 1.0);
  part.clipToRound(Vector2d(3.0, 4.25), Vector2d(0.0, 0.0), 5.0);
  EXPECT_TRUE(part.isEmpty());
}

}  // namespace
}  // namespace swarmanoid
