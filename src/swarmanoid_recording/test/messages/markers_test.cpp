#include "swarmanoid_recording/messages/markers.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "swarmanoid_experiment_files/testing/small_world.hpp"

namespace swarmanoid {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

std::vector<Marker> inNamespace(const MarkerArray& array, const std::string& name) {
  std::vector<Marker> found;
  for (const Marker& marker : array.markers) {
    if (marker.ns == name) {
      found.push_back(marker);
    }
  }
  return found;
}

TEST(MarkersTest, ArenaShowsFloorPatchesBlocksAndLamps) {
  const auto simulation = test::smallWorld();
  simulation->start();
  const MarkerArray arena = arenaMarkers(simulation->space());
  EXPECT_EQ(Marker::DELETEALL, arena.markers.front().action);
  EXPECT_EQ(1U, inNamespace(arena, "floor").size());
  ASSERT_EQ(1U, inNamespace(arena, "floor_patches").size());
  EXPECT_DOUBLE_EQ(0.8, inNamespace(arena, "floor_patches")[0].scale.x);
  ASSERT_EQ(1U, inNamespace(arena, "obstacles").size());
  EXPECT_DOUBLE_EQ(1.0, inNamespace(arena, "obstacles")[0].scale.x);
  EXPECT_EQ(1U, inNamespace(arena, "lights").size());
}

TEST(MarkersTest, HolesAreBlackAndLieOnPatches) {
  Space space;
  space.size = {4.0, 3.0, 1.0};
  FloorPatch patch;
  patch.radius = 0.5;
  space.floor.patches = {patch};
  FloorHole disc;
  disc.position = {1.0, 2.0, 0.7};
  disc.radius = 0.3;
  FloorHole rectangle;
  rectangle.size = {0.4, 0.1};
  space.floor.holes = {disc, rectangle};
  const MarkerArray arena = arenaMarkers(space);
  const std::vector<Marker> holes = inNamespace(arena, "floor_holes");
  ASSERT_EQ(2U, holes.size());
  EXPECT_EQ(Marker::CYLINDER, holes[0].type);
  EXPECT_DOUBLE_EQ(0.6, holes[0].scale.x);
  EXPECT_EQ(2.0, holes[0].pose.position.y);
  EXPECT_EQ(0.0F, holes[0].color.r + holes[0].color.g + holes[0].color.b);
  EXPECT_EQ(1.0F, holes[0].color.a);
  EXPECT_EQ(Marker::CUBE, holes[1].type);
  EXPECT_DOUBLE_EQ(0.1, holes[1].scale.y);
  const auto top = [](const Marker& marker) { return marker.pose.position.z + 0.5 * marker.scale.z; };
  EXPECT_GT(top(holes[0]), top(inNamespace(arena, "floor_patches")[0]));
}

TEST(MarkersTest, TheFloorLeavesRoomForTheTerrain) {
  Space space;
  space.size = {4.0, 3.0, 1.0};
  const auto area = [](const MarkerArray& arena) {
    double sum = 0.0;
    for (const Marker& part : inNamespace(arena, "floor")) {
      sum += part.scale.x * part.scale.y;
    }
    return sum;
  };
  EXPECT_EQ(inNamespace(arenaMarkers(space), "floor").size(), 1U);
  EXPECT_DOUBLE_EQ(area(arenaMarkers(space)), 12.0);
  // a summit of 0.2 m within a level rim
  space.terrain = std::make_shared<const Terrain>(Eigen::Vector2d(1.0, 1.0), Eigen::Vector2d(2.0, 1.0), 3, 3,
                                                  std::vector<double>{0, 0, 0, 0, 0.2, 0, 0, 0, 0});
  const MarkerArray arena = arenaMarkers(space);
  EXPECT_EQ(inNamespace(arena, "floor").size(), 4U);
  EXPECT_DOUBLE_EQ(area(arena), 10.0);
  ASSERT_EQ(inNamespace(arena, "terrain").size(), 1U);
  const Marker terrain = inNamespace(arena, "terrain")[0];
  EXPECT_EQ(terrain.type, Marker::TRIANGLE_LIST);
  EXPECT_EQ(terrain.points.size(), 8U * 3U);
  EXPECT_EQ(terrain.colors.size(), terrain.points.size());
  const auto is_lower = [](const auto& a, const auto& b) { return a.z < b.z; };
  EXPECT_DOUBLE_EQ(std::max_element(terrain.points.begin(), terrain.points.end(), is_lower)->z, 0.2);
  // a raised rim has cliffs too, and none at the border of a large terrain is left out
  space.terrain = std::make_shared<const Terrain>(Eigen::Vector2d(-1.0, 2.0), Eigen::Vector2d(2.0, 2.0), 600, 2,
                                                  std::vector<double>(1200, 0.1));
  const Marker mesa = inNamespace(arenaMarkers(space), "terrain")[0];
  EXPECT_EQ(mesa.points.size(), 3U * (2U * 200U + 2U * 2U * 200U + 4U));
  EXPECT_DOUBLE_EQ(area(arenaMarkers(space)), 11.0);
  EXPECT_DOUBLE_EQ(mesa.points.back().x, 1.0);
}

FloorImage imageOf(int columns, int rows, const Eigen::Vector2d& size) {
  FloorImage image;
  image.corner = {1.0, 0.5};
  image.size = size;
  image.columns = columns;
  image.rows = rows;
  image.colors.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  image.is_opaque.assign(image.colors.size(), 1);
  return image;
}

Marker drawn(const FloorImage& image) {
  Space space;
  space.size = {5.0, 4.0, 1.0};
  space.floor.image = std::make_shared<const FloorImage>(image);
  const std::vector<Marker> found = inNamespace(arenaMarkers(space), "floor_image");
  return found.empty() ? Marker() : found[0];
}

/// Pixels of 1.5 m x 0.25 m, the one at the upper right transparent.
TEST(MarkersTest, AnImageOnTheFloorIsASquareForEachPixel) {
  FloorImage image = imageOf(2, 2, {3.0, 0.5});
  image.colors = {{51, 102, 153}, {1, 2, 3}, {0, 0, 0}, {255, 204, 0}};
  image.is_opaque = {1, 0, 1, 1};
  const Marker marker = drawn(image);
  EXPECT_EQ(marker.type, Marker::CUBE_LIST);
  EXPECT_DOUBLE_EQ(marker.scale.x, 1.5);
  EXPECT_DOUBLE_EQ(marker.scale.y, 0.25);
  ASSERT_EQ(marker.points.size(), 3U);
  ASSERT_EQ(marker.colors.size(), 3U);
  EXPECT_DOUBLE_EQ(marker.points[0].x, 1.75);
  EXPECT_DOUBLE_EQ(marker.points[0].y, 0.875) << "its top is at the greatest y";
  EXPECT_LT(marker.points[0].z, 0.0) << "below patches and paint";
  EXPECT_DOUBLE_EQ(marker.points[2].x, 3.25);
  EXPECT_DOUBLE_EQ(marker.points[2].y, 0.625);
  EXPECT_FLOAT_EQ(marker.colors[0].r, 0.2F);
  EXPECT_FLOAT_EQ(marker.colors[0].g, 0.4F);
  EXPECT_FLOAT_EQ(marker.colors[0].b, 0.6F);
  EXPECT_FLOAT_EQ(marker.colors[1].a, 1.0F) << "black is a colour too";
  EXPECT_FLOAT_EQ(marker.colors[2].g, 0.8F);
  image.is_opaque.assign(4, 0);
  EXPECT_TRUE(drawn(image).points.empty()) << "nothing of it is to be seen";
}

/// One column too many, 129: squares of 2 x 2 pixels of 1 cm, the last one moved inwards.
TEST(MarkersTest, ALargeImageIsDrawnByMeanColours) {
  FloorImage image = imageOf(129, 2, {1.29, 0.02});
  image.colors[0] = {102, 0, 0};
  image.colors[1] = {51, 0, 0};
  const Marker marker = drawn(image);
  ASSERT_EQ(marker.points.size(), 65U);
  EXPECT_DOUBLE_EQ(marker.scale.x, 0.02);
  EXPECT_FLOAT_EQ(marker.colors[0].r, 0.15F);
  EXPECT_NEAR(marker.points[0].x, 1.01, 1e-9);
  EXPECT_NEAR(marker.points[64].x, 1.0 + 1.28, 1e-9);
}

/// Cells of 5 cm; the paint has a half-life of half a second, which is five ticks.
TEST(MarkersTest, PaintIsDrawnByItsCellsAsStrongAsItIs) {
  Experiment experiment = test::smallWorld()->experiment();
  experiment.arena.paint = PaintDescription{0.05, 0.5};
  Simulation simulation(std::move(experiment));
  simulation.start();
  MovingMarkers markers;
  const auto paint = [&] { return inNamespace(markers.draw(simulation.space()), "paint"); };
  EXPECT_TRUE(paint().empty()) << "a clean floor";
  simulation.apply(PaintFloor{{{{3.07, 2.02}, 0.0, colors::kBlue, 0.8}}});
  const auto expectOne = [](const std::vector<Marker>& drawn, double strength) {
    ASSERT_EQ(drawn.size(), 1U);
    EXPECT_DOUBLE_EQ(drawn[0].scale.x, 0.05);
    ASSERT_EQ(drawn[0].points.size(), 1U);
    EXPECT_NEAR(drawn[0].points[0].x, 3.075, 1e-9);
    EXPECT_NEAR(drawn[0].points[0].y, 2.025, 1e-9);
    EXPECT_EQ(drawn[0].colors[0].r, 0.0F);
    EXPECT_EQ(drawn[0].colors[0].b, 1.0F);
    EXPECT_NEAR(drawn[0].colors[0].a, strength, 1e-6);
  };
  expectOne(paint(), 0.8);
  for (int i = 0; i < 5; ++i) {
    simulation.tick();
  }
  expectOne(paint(), 0.4);
  for (int i = 0; i < 40; ++i) {
    simulation.tick();
  }
  const std::vector<Marker> gone = paint();  // 0.8 / 512 is left
  ASSERT_EQ(gone.size(), 1U);
  EXPECT_EQ(gone[0].action, Marker::DELETE);
}

TEST(MarkersTest, IdsStayTheSameAndWhatIsGoneIsDeletedOnce) {
  const auto simulation = test::smallWorld();
  simulation->start();
  MovingMarkers markers;
  const MarkerArray first = markers.draw(simulation->space());
  EXPECT_EQ(3U, inNamespace(first, "labels").size());
  ASSERT_EQ(1U, inNamespace(first, "preys/0").size());
  simulation->tick();
  const MarkerArray second = markers.draw(simulation->space());
  EXPECT_EQ(inNamespace(first, "preys/0")[0].id, inNamespace(second, "preys/0")[0].id);

  simulation->apply(DeleteEntity{"prey"});
  const std::vector<Marker> gone = inNamespace(markers.draw(simulation->space()), "preys/0");
  ASSERT_EQ(1U, gone.size());
  EXPECT_EQ(Marker::DELETE, gone[0].action);
  EXPECT_TRUE(inNamespace(markers.draw(simulation->space()), "preys/0").empty());
}

TEST(MarkersTest, NothingIsSentEmpty) {
  const auto simulation = test::smallWorld();
  simulation->start();
  MovingMarkers markers;
  for (const Marker& marker : markers.draw(simulation->space()).markers) {
    const bool is_list = marker.type >= Marker::LINE_STRIP && marker.type <= Marker::POINTS;
    EXPECT_TRUE(!is_list || !marker.points.empty()) << marker.ns;
    EXPECT_EQ("world", marker.header.frame_id);
  }
}

TEST(MarkersTest, TheGridIsAsOblongAsTheFloor) {
  Space space;
  space.size = {6.0, 2.0, 1.0};
  const auto corners = [](const Marker& grid) {
    Eigen::AlignedBox2d box;
    for (const auto& point : grid.points) {
      box.extend(Eigen::Vector2d(point.x, point.y));
    }
    return box;
  };
  const std::vector<Marker> grids = inNamespace(arenaMarkers(space), "grid");
  ASSERT_EQ(1U, grids.size());
  EXPECT_TRUE(corners(grids[0]).isApprox({Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(6.0, 2.0)}));
  EXPECT_EQ(2U * (13U + 5U), grids[0].points.size());  // cells of 0.5 m

  space.size = {12.65, 12.65, 1.0};
  EXPECT_EQ(2U * (13U + 13U), inNamespace(arenaMarkers(space), "grid")[0].points.size());  // cells of 1 m
}

TEST(MarkersTest, TheGridLeavesRoomForTheTerrain) {
  Space space;
  space.size = {4.0, 3.0, 1.0};
  space.terrain = std::make_shared<const Terrain>(Eigen::Vector2d(1.0, 1.0), Eigen::Vector2d(2.0, 1.0), 2, 2,
                                                  std::vector<double>(4, 0.0));
  const Marker grid = inNamespace(arenaMarkers(space), "grid")[0];
  for (std::size_t i = 0; i + 1 < grid.points.size(); i += 2) {
    const double x = 0.5 * (grid.points[i].x + grid.points[i + 1].x);
    const double y = 0.5 * (grid.points[i].y + grid.points[i + 1].y);
    EXPECT_FALSE(x > 1.0 && x < 3.0 && y > 1.0 && y < 2.0);
  }
  space.terrain = std::make_shared<const Terrain>(Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(4.0, 3.0), 2, 2,
                                                  std::vector<double>(4, 0.0));
  EXPECT_TRUE(inNamespace(arenaMarkers(space), "grid").empty());
}

TEST(MarkersTest, OneCanSeeThroughACeiling) {
  Simulation simulation(parseExperiment(R"(
<ahss-config>
  <framework><clocktick>100</clocktick><maxclock>10</maxclock></framework>
  <arena size="4,3,2.6" optimization="3D">
    <block id="ceiling"><position>2, 1.5, 2.55</position><orientation>0, 0, 0</orientation><size>4, 3, 0.1</size></block>
    <block id="pillar"><position>2, 1.5, 1.25</position><orientation>0, 0, 0</orientation><size>0.1, 0.1, 2.5</size></block>
  </arena>
</ahss-config>)",
                                        "ceiling.xml"));
  simulation.start();
  const std::vector<Marker> obstacles = inNamespace(arenaMarkers(simulation.space()), "obstacles");
  ASSERT_EQ(2U, obstacles.size());
  EXPECT_GT(0.5F, obstacles[0].color.a);
  EXPECT_FLOAT_EQ(1.0F, obstacles[1].color.a);
}

}  // namespace
}  // namespace swarmanoid
