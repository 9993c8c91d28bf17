// Colours of the floor: paint, patches (the last one of the file on top), an image, and the bare floor around them.
#include "swarmanoid_space/state/floor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_experiment_files/testing/write_png.hpp"
#include "swarmanoid_interface/process/temporary_folder.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

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

TEST(FloorHoleTest, IsWhereThereIsNoTerrain) {
  Space space;
  EXPECT_EQ(space.holeAt({1.0, 1.0, 0.0}), nullptr);
  FloorHole hole;
  hole.id = "disc";
  hole.position = {1.0, 1.0, 0.0};
  hole.radius = 0.5;
  FloorHole other;
  other.id = "strip";
  other.position = {1.4, 1.0, 0.0};
  other.size = {0.6, 3.0};
  space.floor.holes = {hole, other};
  ASSERT_NE(space.holeAt({1.3, 1.4, 0.7}), nullptr);
  EXPECT_EQ(space.holeAt({1.3, 1.4, 0.7})->id, "disc") << "its border, and at any height";
  EXPECT_EQ(space.holeAt({1.31, 1.4, 0.0})->id, "strip");
  EXPECT_EQ(space.holeAt({0.7, 0.59, 0.0}), nullptr);
  space.terrain = std::make_shared<const Terrain>(Eigen::Vector2d(1.0, 0.0), Eigen::Vector2d(1.0, 2.0), 2, 2,
                                                  std::vector<double>(4, 0.0));
  EXPECT_EQ(space.holeAt({1.3, 1.4, 0.0}), nullptr) << "there the terrain is the ground";
  EXPECT_NE(space.holeAt({0.9, 1.0, 0.0}), nullptr);
}

TEST(FloorTest, IsWhiteWhereNobodySaysOtherwise) {
  Floor floor;
  EXPECT_EQ(floor.colorAt({3.0, -4.0, 0.0}, 0), colors::kWhite);
  floor.bare = {7, 8, 9};
  EXPECT_EQ(floor.colorAt({3.0, -4.0, 0.0}, 0), (Color{7, 8, 9}));
}

/// A red disc, a strip across it, and a blue disc on both.
TEST(FloorTest, LaterPatchesLieOnEarlierOnes) {
  Floor floor;
  floor.patches = {disc(1.0, 2.0, 0.5, colors::kRed), rectangle(1.0, 2.0, {2.0, 0.2}, colors::kGreen),
                   disc(1.4, 2.0, 0.05, colors::kBlue)};
  EXPECT_EQ(floor.colorAt({1.0, 2.3, 0.0}, 0), colors::kRed);
  EXPECT_EQ(floor.colorAt({1.0, 2.05, 0.0}, 0), colors::kGreen);
  EXPECT_EQ(floor.colorAt({1.9, 1.95, 0.0}, 0), colors::kGreen) << "beside the disc";
  EXPECT_EQ(floor.colorAt({1.42, 2.03, 0.0}, 0), colors::kBlue);
  EXPECT_EQ(floor.colorAt({1.44, 2.04, 0.0}, 0), colors::kGreen) << "0.057 m from its middle";
  EXPECT_EQ(floor.colorAt({1.4, 2.4, 0.0}, 0), colors::kWhite) << "0.566 m from the middle of the red one";
  floor.patches.push_back(floor.patches.front());
  EXPECT_EQ(floor.colorAt({1.42, 2.03, 0.0}, 0), colors::kRed);
}

TEST(FloorTest, BlackIsAColourToo) {
  Floor floor;
  floor.patches = {disc(0.0, 0.0, 1.0, colors::kGreen), rectangle(0.0, 0.0, {0.5, 0.5}, colors::kBlack)};
  EXPECT_EQ(floor.colorAt({0.2, -0.2, 0.0}, 0), colors::kBlack) << "and does not show what lies under it";
}

TEST(FloorTest, HeightsDoNotCount) {
  Floor floor;
  floor.patches = {disc(0.0, 0.0, 1.0, colors::kGreen)};
  floor.patches[0].position.z() = 0.3;
  for (const double height : {-1.0, 0.0, 0.3, 5.0}) {
    EXPECT_EQ(floor.colorAt({0.5, 0.5, height}, 0), colors::kGreen) << height;
    EXPECT_EQ(floor.colorAt({0.8, 0.8, height}, 0), colors::kWhite) << height;
  }
}

TEST(FloorTest, IsBareAroundWhatLiesFarFromAllPatches) {
  Floor floor;
  EXPECT_TRUE(floor.isBareAround({7.0, -2.0, 0.0}, 100.0));
  floor.patches = {disc(1.0, 2.0, 0.5, colors::kRed), rectangle(3.0, 2.0, {0.4, 1.2}, colors::kGreen)};
  EXPECT_TRUE(floor.isBareAround({-0.3, 2.0, 0.7}, 0.79)) << "0.8 m from the disc, at any height";
  EXPECT_FALSE(floor.isBareAround({-0.3, 2.0, 0.0}, 0.81));
  EXPECT_TRUE(floor.isBareAround({3.0, 2.95, 0.0}, 0.34)) << "0.35 m from the rectangle";
  EXPECT_FALSE(floor.isBareAround({3.0, 2.95, 0.0}, 0.36));
  EXPECT_FALSE(floor.isBareAround({3.1, 2.1, 0.0}, 0.0)) << "on it";
}

TEST(FloorTest, NothingButTheBareFloorIsSeenWhereItIsBareAround) {
  Floor floor;
  floor.patches = {disc(1.0, 2.0, 0.5, colors::kRed), rectangle(1.8, 2.3, {0.5, 0.3}, colors::kGreen)};
  constexpr double kDistance = 0.23;
  int bare = 0;
  int in_doubt = 0;
  for (int i = 0; i < 40 * 40; ++i) {
    const Eigen::Vector3d middle(0.07 * (i % 40), 0.6 + 0.07 * (i / 40), 0.0);
    bool is_bare = true;
    for (int k = 0; k < 64; ++k) {
      const double angle = k * M_PI / 32.0;
      const Eigen::Vector3d border = middle + kDistance * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0);
      is_bare = is_bare && floor.colorAt(border, 0) == colors::kWhite;
    }
    is_bare = is_bare && floor.colorAt(middle, 0) == colors::kWhite;
    const bool says_bare = floor.isBareAround(middle, kDistance);
    ASSERT_TRUE(is_bare || !says_bare) << middle.transpose();
    bare += is_bare ? 1 : 0;
    in_doubt += is_bare && !says_bare ? 1 : 0;
  }
  EXPECT_GT(bare, 1000);
  EXPECT_LT(in_doubt, 150) << "beside the corners of the square around the disc, and of the rectangle";
}

/// An image of 3 x 2 pixels, from (1, 2) to (4, 3.2); the lower middle one is transparent.
std::shared_ptr<const FloorImage> smallImage() {
  auto image = std::make_shared<FloorImage>();
  image->corner = {1.0, 2.0};
  image->size = {3.0, 1.2};
  image->columns = 3;
  image->rows = 2;
  image->colors = {{10, 0, 0}, {20, 0, 0}, {30, 0, 0}, {40, 0, 0}, {50, 0, 0}, {60, 0, 0}};
  image->is_opaque = {1, 1, 1, 1, 0, 1};
  return image;
}

TEST(FloorTest, IsNotBareAroundAnythingWhereThereIsAnImageOrPaint) {
  Floor floor;
  floor.paint = PaintLayer({5.0, 5.0}, 0.1, 10.0);
  EXPECT_TRUE(floor.isBareAround({1.0, 1.0, 0.0}, 0.1)) << "nothing is painted yet";
  floor.paint.paint({{4.0, 4.0}, 0.3, colors::kRed, 0.5}, 0);
  EXPECT_FALSE(floor.isBareAround({1.0, 1.0, 0.0}, 0.1));
  floor.paint = PaintLayer();
  floor.image = smallImage();
  EXPECT_FALSE(floor.isBareAround({0.1, 0.1, 0.0}, 0.1));
}

TEST(FloorTest, AnImageLiesWithItsTopAtTheGreatestY) {
  Floor floor;
  floor.image = smallImage();
  EXPECT_EQ(floor.colorAt({1.3, 3.1, 0.0}, 0), (Color{10, 0, 0}));
  EXPECT_EQ(floor.colorAt({3.9, 2.65, 0.0}, 0), (Color{30, 0, 0}));
  EXPECT_EQ(floor.colorAt({1.99, 2.55, 0.0}, 0), (Color{40, 0, 0}));
  EXPECT_EQ(floor.colorAt({2.5, 2.3, 0.0}, 0), colors::kWhite) << "transparent";
  EXPECT_EQ(floor.colorAt({3.01, 2.1, 0.0}, 0), (Color{60, 0, 0}));
  EXPECT_EQ(floor.colorAt({0.999, 2.5, 0.0}, 0), colors::kWhite) << "beside it";
  EXPECT_EQ(floor.colorAt({2.5, 3.201, 0.0}, 0), colors::kWhite);
}

TEST(FloorTest, AnImageEndsAtItsBorders) {
  Floor floor;
  floor.image = smallImage();
  EXPECT_EQ(floor.colorAt({1.0, 2.0, 0.0}, 0), (Color{40, 0, 0}));
  EXPECT_EQ(floor.colorAt({4.0, 3.2, 0.0}, 0), (Color{30, 0, 0}));
  EXPECT_EQ(floor.colorAt({2.0, 3.0, 0.0}, 0), (Color{20, 0, 0})) << "of two pixels the one with the larger x";
}

/// The image has 2 x 2 pixels, from (1.5, 0.5) to (4.5, 1.9), and is in a folder beside the experiment file.
TEST(FloorTest, AnExperimentFileNamesAnImage) {
  const TemporaryFolder folder("floor_test");
  std::filesystem::create_directory(folder.path() / "images");
  test::writePng(folder.path() / "images/small.png", 2, 8, {201, 2, 3, 4, 205, 6, 7, 8, 209, 210, 211, 12},
                 PNG_COLOR_TYPE_RGB);
  const std::filesystem::path file = folder.path() / "floor.xml";
  std::ofstream(file) << R"(<ahss-config>
  <framework><clocktick>100</clocktick><maxclock>10</maxclock></framework>
  <arena size="5,4,1" optimization="2D" floor="10,20,30">
    <floor_image><file>images/small.png</file><position>3, 1.2, 0</position><size>3, 1.4</size></floor_image>
  </arena>
</ahss-config>)";
  Simulation simulation(readExperiment(file));
  simulation.start();
  const Floor& floor = simulation.space().floor;
  EXPECT_EQ(floor.colorAt({1.6, 1.8, 0.0}, 0), (Color{201, 2, 3})) << "its upper left: small x, large y";
  EXPECT_EQ(floor.colorAt({4.4, 1.3, 0.0}, 0), (Color{4, 205, 6}));
  EXPECT_EQ(floor.colorAt({2.9, 0.6, 0.0}, 0), (Color{7, 8, 209}));
  EXPECT_EQ(floor.colorAt({3.1, 1.1, 0.0}, 0), (Color{210, 211, 12}));
  for (const Eigen::Vector3d& outside : {Eigen::Vector3d(1.4, 1.2, 0.0), Eigen::Vector3d(4.6, 1.2, 0.0),
                                         Eigen::Vector3d(3.1, 0.4, 0.0), Eigen::Vector3d(3.1, 2.0, 0.0)}) {
    EXPECT_EQ(floor.colorAt(outside, 0), (Color{10, 20, 30})) << outside.transpose();
  }
}

TEST(FloorTest, PatchesLieOnTheImageAndPaintOnThem) {
  Floor floor;
  floor.image = smallImage();
  floor.patches = {disc(1.5, 3.0, 0.1, colors::kGreen)};
  floor.paint = PaintLayer({5.0, 5.0}, 0.1, 10.0);
  EXPECT_EQ(floor.colorAt({1.5, 3.05, 0.0}, 0), colors::kGreen);
  floor.paint.paint({{1.5, 3.0}, 0.3, colors::kRed, 0.5}, 0);
  EXPECT_EQ(floor.colorAt({1.5, 3.05, 0.0}, 0), (Color{128, 128, 0}));
  EXPECT_EQ(floor.colorAt({1.5, 3.05, 0.0}, 10), (Color{64, 191, 0})) << "0.25 of it is left";
  EXPECT_EQ(floor.unpaintedColorAt({1.5, 3.05, 0.0}), colors::kGreen);
  EXPECT_EQ(floor.colorAt({1.5, 2.85, 0.0}, 0), (Color{133, 0, 0})) << "over the image";
}

}  // namespace
}  // namespace swarmanoid
