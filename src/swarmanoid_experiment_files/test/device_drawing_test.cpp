// Drawing functions of devices, and the selection of robots whose devices are drawn.
#include "swarmanoid_space/device_drawing.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "swarmanoid_experiment_files/testing/small_world.hpp"

namespace swarmanoid {
namespace {

using Eigen::Vector3d;

constexpr Color kAny{1, 2, 3};

void expectLine(const DeviceDrawing::Line& line, const Vector3d& from, const Vector3d& to) {
  EXPECT_NEAR((line.from - from).norm(), 0.0, 1e-7) << line.from.transpose();
  EXPECT_NEAR((line.to - to).norm(), 0.0, 1e-7) << line.to.transpose();
}

TEST(DeviceDrawingTest, AnArcIsOfPiecesOfAtMost15Degrees) {
  DeviceDrawing drawing;
  // an arc of 31 degrees about z from 20 degrees, at (1, 2, 3), radii of 2 and 0.5 m
  drawing.arc({1.0, 2.0, 3.0}, 2.0 * Vector3d::UnitX(), 0.5 * Vector3d::UnitY(), 0.349065850, 0.890117919, kAny);
  ASSERT_EQ(drawing.lines().size(), 3U);
  expectLine(drawing.lines()[0], {2.879385242, 2.171010072, 3.0}, {2.726203764, 2.252514921, 3.0});
  expectLine(drawing.lines()[2], drawing.lines()[1].to, {2.258640782, 2.388572981, 3.0});
  drawing.clear();
  drawing.circle({1.0, 2.0, 3.0}, Vector3d::UnitY(), Vector3d::UnitZ(), kAny);
  ASSERT_EQ(drawing.lines().size(), 24U);
  expectLine(drawing.lines()[6], {1.0, 2.0, 4.0}, {1.0, 2.0 - 0.258819045, 3.965925826});
  expectLine(drawing.lines()[23], {1.0, 2.965925826, 2.741180955}, {1.0, 3.0, 3.0});
}

TEST(DeviceDrawingTest, AConeHasFourEdges) {
  DeviceDrawing drawing;
  drawing.cone({1.0, 2.0, 3.0}, {1.0, 2.0, 0.0}, 0.7 * Vector3d::UnitX(), 0.7 * Vector3d::UnitY(), kAny);
  ASSERT_EQ(drawing.lines().size(), 28U);
  expectLine(drawing.lines()[24], {1.0, 2.0, 3.0}, {1.7, 2.0, 0.0});
  expectLine(drawing.lines()[27], {1.0, 2.0, 3.0}, {1.0, 1.3, 0.0});
}

TEST(DeviceDrawingTest, AnArrowHasAHeadAtItsTip) {
  DeviceDrawing drawing;
  drawing.arrow({1.0, 2.0, 3.0}, {1.3, 2.4, 3.0}, kAny);  // level, 0.5 m
  ASSERT_EQ(drawing.lines().size(), 3U);
  expectLine(drawing.lines()[0], {1.0, 2.0, 3.0}, {1.3, 2.4, 3.0});
  expectLine(drawing.lines()[1], {1.3, 2.4, 3.0}, {1.24, 2.32, 3.05});
  expectLine(drawing.lines()[2], {1.3, 2.4, 3.0}, {1.24, 2.32, 2.95});
  drawing.clear();
  drawing.arrow({1.0, 2.0, 3.0}, {1.0, 2.0, 3.5}, kAny);  // upright
  expectLine(drawing.lines()[1], {1.0, 2.0, 3.5}, {1.05, 2.0, 3.4});
}

TEST(DeviceDrawingTest, ShadesGoFromBluishGreyToRed) {
  EXPECT_EQ(DeviceDrawing::shade(0.0), (Color{110, 140, 190}));
  EXPECT_EQ(DeviceDrawing::shade(0.3), (Color{154, 98, 133}));
  EXPECT_EQ(DeviceDrawing::shade(1.0), colors::kRed);
  EXPECT_EQ(DeviceDrawing::shade(-2.0), DeviceDrawing::shade(0.0));
  EXPECT_EQ(DeviceDrawing::shade(17.0), colors::kRed);
}

TEST(DeviceDrawingTest, ClearingKeepsTheRoom) {
  DeviceDrawings drawings;
  EXPECT_FALSE(drawings.of("radio").isUsed());
  drawings.of("radio").line(Vector3d::Zero(), Vector3d::UnitX(), kAny);
  drawings.of("radio").point(Vector3d::Zero(), kAny);
  const DeviceDrawing::Line* place = drawings.of("radio").lines().data();
  drawings.clear();
  EXPECT_TRUE(drawings.of("radio").lines().empty());
  EXPECT_TRUE(drawings.of("radio").points().empty());
  EXPECT_TRUE(drawings.of("radio").isUsed()) << "it has a place in displays";
  drawings.of("radio").line(Vector3d::Zero(), Vector3d::UnitX(), kAny);
  EXPECT_EQ(drawings.of("radio").lines().data(), place);
  EXPECT_EQ(drawings.all().size(), 1U);
}

/// Three robots with controllers, fb_1, fb_2 and eb; those of the small world have none.
Experiment threeRobots() {
  Experiment experiment = test::smallWorld()->experiment();
  for (EntityDescription& entity : experiment.arena.entities) {
    if (entity.id == "fb_1" || entity.id == "fb_2" || entity.id == "eb") {
      entity.controller = "c";
    }
  }
  return experiment;
}

TEST(DrawnRobotsTest, AreAllUnlessSomeAreNamed) {
  const Experiment experiment = threeRobots();
  for (const std::vector<std::string>& words : {std::vector<std::string>{}, {"all"}}) {
    EXPECT_TRUE(chooseDrawnRobots(words, "~device_markers", experiment).has("anybody"));
  }
  const DrawnRobots some = chooseDrawnRobots({"fb_*", "eb"}, "~device_markers", experiment);
  EXPECT_TRUE(some.has("fb_2"));
  EXPECT_TRUE(some.has("fb_17")) << "spawned later";
  EXPECT_TRUE(some.has("eb"));
  EXPECT_FALSE(some.has("eb_1"));
  EXPECT_FALSE(some.has("fb"));
  EXPECT_TRUE(chooseDrawnRobots({"*"}, "~device_markers", experiment).has("eb"));
}

TEST(DrawnRobotsTest, AWordThatFitsNobodyIsRefused) {
  const Experiment experiment = threeRobots();
  const auto refusal = [&](const std::vector<std::string>& words) -> std::string {
    try {
      chooseDrawnRobots(words, "~device_markers", experiment);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal({"fb_1", "fb_3"}),
            "small_world.xml: ~device_markers: found 'fb_3', allowed: all, or beginnings of names that end with *, or "
            "fb_1, fb_2, eb; did you mean 'fb_1'?");
  EXPECT_NE(refusal({"hb*"}).find("found 'hb*', allowed: all, or"), std::string::npos);
  EXPECT_NE(refusal({"all", "fb_1"}).find("found 'all'"), std::string::npos) << "all stands alone";
}

}  // namespace
}  // namespace swarmanoid
