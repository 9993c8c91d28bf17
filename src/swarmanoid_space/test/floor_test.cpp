// The colours of the floor: patches, the last one of the file on top, and the bare floor around them.
#include "swarmanoid_space/state/floor.hpp"

#include <gtest/gtest.h>

namespace swarmanoid {
namespace {

TEST(FloorPatchTest, DiscAndRectangle) {
  FloorPatch disc;
  disc.position = {1, 1, 0};
  disc.radius = 0.5;
  EXPECT_TRUE(disc.contains({1.5, 1, 2}));
  EXPECT_FALSE(disc.contains({1.4, 1.4, 0}));
  EXPECT_EQ(disc.nearestPoint({3, 1, 2}), Eigen::Vector3d(1.5, 1, 0));
  EXPECT_EQ(disc.nearestPoint({1.25, 1, 2}), Eigen::Vector3d(1.25, 1, 0));

  FloorPatch rectangle;
  rectangle.position = {1, 1, 0};
  rectangle.size = {2, 1};
  EXPECT_TRUE(rectangle.contains({2, 1.5, 0}));
  EXPECT_FALSE(rectangle.contains({2, 1.6, 0}));
  EXPECT_EQ(rectangle.nearestPoint({5, 5, 1}), Eigen::Vector3d(2, 1.5, 0));
  EXPECT_EQ(rectangle.nearestPoint({1.5, 5, 1}), Eigen::Vector3d(1.5, 1.5, 0));
}

FloorPatch disc(double x, double y, double radius, Color color) {
  FloorPatch patch;
  patch.position = {x, y, 0.0};
  patch.radius = radius;
  patch.color = color;
  return patch;
}

FloorPatch rectangle(double x, double y, const Eigen::Vector2d& size, Color color) {
  FloorPatch patch;
  patch.position = {x, y, 0.0};
  patch.size = size;
  patch.color = color;
  return patch;
}

TEST(FloorTest, IsWhiteWhereNobodySaysOtherwise) {
  Floor floor;
  EXPECT_EQ(floor.colorAt({3.0, -4.0, 0.0}), colors::kWhite);
  floor.bare = {7, 8, 9};
  EXPECT_EQ(floor.colorAt({3.0, -4.0, 0.0}), (Color{7, 8, 9}));
}

/// A red disc, a strip across it, and a blue disc on both.
TEST(FloorTest, LaterPatchesLieOnEarlierOnes) {
  Floor floor;
  floor.patches = {disc(1.0, 2.0, 0.5, colors::kRed), rectangle(1.0, 2.0, {2.0, 0.2}, colors::kGreen),
                   disc(1.4, 2.0, 0.05, colors::kBlue)};
  EXPECT_EQ(floor.colorAt({1.0, 2.3, 0.0}), colors::kRed);
  EXPECT_EQ(floor.colorAt({1.0, 2.05, 0.0}), colors::kGreen);
  EXPECT_EQ(floor.colorAt({1.9, 1.95, 0.0}), colors::kGreen) << "beside the disc";
  EXPECT_EQ(floor.colorAt({1.42, 2.03, 0.0}), colors::kBlue);
  EXPECT_EQ(floor.colorAt({1.44, 2.04, 0.0}), colors::kGreen) << "0.057 m from its middle";
  EXPECT_EQ(floor.colorAt({1.4, 2.4, 0.0}), colors::kWhite) << "0.566 m from the middle of the red one";
  floor.patches.push_back(floor.patches.front());
  EXPECT_EQ(floor.colorAt({1.42, 2.03, 0.0}), colors::kRed);
}

TEST(FloorTest, BlackIsAColourToo) {
  Floor floor;
  floor.patches = {disc(0.0, 0.0, 1.0, colors::kGreen), rectangle(0.0, 0.0, {0.5, 0.5}, colors::kBlack)};
  EXPECT_EQ(floor.colorAt({0.2, -0.2, 0.0}), colors::kBlack) << "and does not show what lies under it";
}

TEST(FloorTest, HeightsDoNotCount) {
  Floor floor;
  floor.patches = {disc(0.0, 0.0, 1.0, colors::kGreen)};
  floor.patches[0].position.z() = 0.3;
  for (const double height : {-1.0, 0.0, 0.3, 5.0}) {
    EXPECT_EQ(floor.colorAt({0.5, 0.5, height}), colors::kGreen) << height;
    EXPECT_EQ(floor.colorAt({0.8, 0.8, height}), colors::kWhite) << height;
  }
}

}  // namespace
}  // namespace swarmanoid
