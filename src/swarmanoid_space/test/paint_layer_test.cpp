// Paint: cells covered by a disc, layering, and fading. Expected values are calculated by hand.
#include "swarmanoid_space/state/paint_layer.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace swarmanoid {
namespace {

const Eigen::Vector2d kSize(1.0, 0.7);
constexpr double kCell = 0.1;  // 10 x 7 cells
constexpr double kHalfLife = 7.3;

PaintDisc disc(double x, double y, double radius, Color color = colors::kBlack, double strength = 1.0) {
  return {{x, y}, radius, color, strength};
}

TEST(PaintLayerTest, WithoutOneTheFloorIsSeen) {
  const PaintLayer none;
  EXPECT_FALSE(none.exists());
  EXPECT_EQ(none.over(colors::kRed, {0.3, 0.3}, 12), colors::kRed);
  const PaintLayer clean(kSize, kCell, 0.0);
  EXPECT_TRUE(clean.exists());
  EXPECT_EQ(clean.over(colors::kRed, {0.3, 0.3}, 12), colors::kRed);
  EXPECT_EQ(clean.digest(), 0U);
}

/// The nearest middles of cells are 0.028, 0.0825, 0.0825 and 0.113 m away.
TEST(PaintLayerTest, ADiscCoversTheCellsWhoseMiddlesAreInIt) {
  for (const auto& [radius, cells] : {std::pair(0.08, 1U), std::pair(0.083, 3U), std::pair(0.114, 4U)}) {
    PaintLayer paint(kSize, kCell, 0.0);
    paint.paint(disc(0.33, 0.27, radius), 0);
    EXPECT_EQ(paint.spotCount(), cells) << radius;
    EXPECT_EQ(paint.over(colors::kWhite, {0.301, 0.299}, 0), colors::kBlack) << "of the cell around (0.35, 0.25)";
    EXPECT_EQ(paint.over(colors::kWhite, {0.401, 0.299}, 0), colors::kWhite) << "and not of the one beside it";
  }
}

TEST(PaintLayerTest, ADiscWithoutAMiddleOfACellPaintsTheCellBelowIt) {
  PaintLayer paint(kSize, kCell, 0.0);
  paint.paint(disc(0.309, 0.291, 0.02), 0);
  ASSERT_EQ(paint.spotCount(), 1U);
  EXPECT_NEAR((paint.spot(0, 0).position - Eigen::Vector2d(0.35, 0.25)).norm(), 0.0, 1e-12);
  paint.paint(disc(1.0, 0.7, 0.0), 0);
  ASSERT_EQ(paint.spotCount(), 2U);
  EXPECT_NEAR((paint.spot(1, 0).position - Eigen::Vector2d(0.95, 0.65)).norm(), 0.0, 1e-12) << "at the far corner";
}

TEST(PaintLayerTest, ADiscBeyondTheBorderPaintsWhatIsInside) {
  PaintLayer paint(kSize, kCell, 0.0);
  paint.paint(disc(0.02, 0.02, 0.14), 0);
  EXPECT_EQ(paint.spotCount(), 3U) << "(0.05, 0.05) and its neighbours, 0.133 m away";
  paint.paint(disc(0.5, 0.35, 9.0), 0);
  EXPECT_EQ(paint.spotCount(), 70U);
  EXPECT_EQ(paint.over(colors::kWhite, {-0.001, 0.1}, 0), colors::kWhite) << "outside there is none";
  EXPECT_EQ(paint.over(colors::kWhite, {0.1, 0.7001}, 0), colors::kWhite);
}

TEST(PaintLayerTest, TheColoursOfTwoAreMixedByTheirStrengths) {
  PaintLayer paint(kSize, kCell, 0.0);
  paint.paint(disc(0.5, 0.3, 0.2, colors::kBlue, 0.35), 0);
  paint.paint(disc(0.5, 0.3, 0.2, colors::kRed, 0.6), 0);
  const PaintLayer::Spot spot = paint.spot(0, 0);
  EXPECT_NEAR(spot.strength, 0.74, 1e-7) << "0.6 + 0.35 * 0.4";
  EXPECT_EQ(spot.color, (Color{207, 0, 48})) << "0.6 / 0.74 of the later one";
  EXPECT_EQ(paint.over(colors::kWhite, {0.5, 0.3}, 0), (Color{219, 66, 102}));
  EXPECT_EQ(paint.over(colors::kBlack, {0.5, 0.3}, 0), (Color{153, 0, 36}));
}

TEST(PaintLayerTest, FullPaintHidesWhatWasThere) {
  PaintLayer paint(kSize, kCell, 0.0);
  paint.paint(disc(0.5, 0.3, 0.2, colors::kBlue, 0.9), 0);
  paint.paint(disc(0.5, 0.3, 0.2, {1, 2, 3}, 1.0), 0);
  EXPECT_EQ(paint.over(colors::kWhite, {0.5, 0.3}, 0), (Color{1, 2, 3}));
}

/// 0.3 falls to 0.0494 after 19 ticks; 0.25 on top of it gives 0.2870, which falls to 0.0835 after 13 more.
TEST(PaintLayerTest, IsHalvedEachHalfLifeAndPaintOverItStartsFromWhatIsLeft) {
  PaintLayer paint(kSize, kCell, kHalfLife);
  paint.paint(disc(0.5, 0.3, 0.0, colors::kBlack, 0.3), 5);
  EXPECT_NEAR(paint.spot(0, 5).strength, 0.3, 1e-7);
  EXPECT_NEAR(paint.spot(0, 24).strength, 0.3 * std::exp2(-19.0 / kHalfLife), 1e-8);
  paint.paint(disc(0.5, 0.3, 0.0, colors::kBlack, 0.25), 24);
  EXPECT_NEAR(paint.spot(0, 24).strength, 0.287040751534378, 1e-7);
  EXPECT_EQ(paint.over(colors::kWhite, {0.5, 0.3}, 24), (Color{182, 182, 182}));
  EXPECT_NEAR(paint.spot(0, 37).strength, 0.287040751534378 * std::exp2(-13.0 / kHalfLife), 1e-7);
  EXPECT_EQ(paint.spotCount(), 1U);
}

TEST(PaintLayerTest, IsNotSeenAnyMoreBelowHalfAStepOfAColour) {
  PaintLayer paint(kSize, kCell, 3.0);
  paint.paint(disc(0.5, 0.3, 0.0), 100);
  EXPECT_NEAR(paint.spot(0, 126).strength, std::exp2(-26.0 / 3.0), 1e-12);
  EXPECT_EQ(paint.over(colors::kWhite, {0.5, 0.3}, 126), (Color{254, 254, 254}));
  EXPECT_EQ(paint.spot(0, 128).strength, 0.0) << "2^-9.3";
  EXPECT_EQ(paint.over(colors::kWhite, {0.5, 0.3}, 128), colors::kWhite);
  EXPECT_EQ(paint.over(colors::kWhite, {0.5, 0.3}, 1000000000000), colors::kWhite);
}

TEST(PaintLayerTest, WithoutAHalfLifeItStays) {
  PaintLayer paint(kSize, kCell, 0.0);
  paint.paint(disc(0.5, 0.3, 0.0, colors::kBlue, 0.5), 3);
  EXPECT_EQ(paint.spot(0, 1000000000000).strength, 0.5);
}

TEST(PaintLayerTest, DigestsTellWhatWasPaintedWhereAndWhen) {
  const auto digestOf = [](std::initializer_list<std::pair<PaintDisc, std::uint64_t>> discs) {
    PaintLayer paint(kSize, kCell, kHalfLife);
    for (const auto& [each, tick] : discs) {
      paint.paint(each, tick);
    }
    return paint.digest();
  };
  const PaintDisc first = disc(0.5, 0.3, 0.12, colors::kRed, 0.5);
  const PaintDisc second = disc(0.6, 0.3, 0.12, colors::kBlue, 0.5);
  const std::uint64_t both = digestOf({{first, 2}, {second, 9}});
  EXPECT_EQ(digestOf({{first, 2}, {second, 9}}), both);
  EXPECT_NE(digestOf({{second, 2}, {first, 9}}), both);
  EXPECT_NE(digestOf({{first, 2}, {second, 8}}), both);
  EXPECT_NE(digestOf({{first, 2}}), both);
  EXPECT_NE(digestOf({{first, 2}}), digestOf({{disc(0.5, 0.3, 0.12, colors::kRed, 0.51), 2}}));
  EXPECT_NE(digestOf({{first, 2}}), digestOf({{disc(0.5, 0.3, 0.12, {254, 0, 0}, 0.5), 2}}));
  EXPECT_NE(digestOf({{first, 2}}), digestOf({{disc(0.4, 0.3, 0.12, colors::kRed, 0.5), 2}}));
}

}  // namespace
}  // namespace swarmanoid
