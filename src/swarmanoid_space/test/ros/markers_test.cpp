#include "swarmanoid_space/ros/markers.hpp"

#include <gtest/gtest.h>

#include "../small_world.hpp"

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

  simulation->remove("prey");
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

}  // namespace
}  // namespace swarmanoid
