// Drawings of devices as markers.
#include <gtest/gtest.h>

#include "swarmanoid_experiment_files/testing/small_world.hpp"
#include "swarmanoid_recording/messages/markers.hpp"
#include "swarmanoid_space/device_drawing.hpp"

namespace swarmanoid {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

TEST(DeviceMarkersTest, EachTypeThatDrawsHasLinesAndPoints) {
  const auto simulation = test::smallWorld();
  DeviceDrawings drawings;
  drawings.of("wheels");
  drawings.of("radio").line({1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}, {51, 102, 153});
  drawings.of("radio").line({1.5, 2.0, 3.0}, {4.0, 5.0, 6.5}, colors::kRed);
  drawings.of("ground").point({0.5, 0.25, 0.0}, {0, 204, 0});
  MarkerArray message;
  deviceMarkers(simulation->space(), drawings, message);
  ASSERT_EQ(message.markers.size(), 4U) << "of ground and radio";
  const Marker& points = message.markers[1];
  EXPECT_EQ(points.ns, "devices/ground");
  EXPECT_EQ(points.type, Marker::POINTS);
  EXPECT_EQ(points.action, Marker::ADD);
  EXPECT_EQ(points.header.frame_id, "world");
  ASSERT_EQ(points.points.size(), 1U);
  EXPECT_DOUBLE_EQ(points.points[0].y, 0.25);
  EXPECT_FLOAT_EQ(points.colors.at(0).g, 0.8F);
  EXPECT_EQ(message.markers[0].action, Marker::DELETE) << "ground has no lines";
  const Marker& lines = message.markers[2];
  EXPECT_EQ(lines.ns, "devices/radio");
  EXPECT_EQ(lines.type, Marker::LINE_LIST);
  EXPECT_NE(lines.id, message.markers[3].id);
  EXPECT_GT(lines.scale.x, 0.0);
  ASSERT_EQ(lines.points.size(), 4U);
  ASSERT_EQ(lines.colors.size(), 4U);
  EXPECT_DOUBLE_EQ(lines.points[3].z, 6.5);
  EXPECT_FLOAT_EQ(lines.colors[0].b, 0.6F);
  EXPECT_FLOAT_EQ(lines.colors[1].b, 0.6F);
  EXPECT_FLOAT_EQ(lines.colors[2].r, 1.0F);
  EXPECT_FLOAT_EQ(lines.colors[2].a, 1.0F);
}

TEST(DeviceMarkersTest, WhatIsGoneIsDeletedUnderTheSameId) {
  const auto simulation = test::smallWorld();
  DeviceDrawings drawings;
  MarkerArray message;
  drawings.of("radio").line({1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}, colors::kRed);
  deviceMarkers(simulation->space(), drawings, message);
  const int id = message.markers.at(0).id;
  drawings.clear();
  deviceMarkers(simulation->space(), drawings, message);
  ASSERT_EQ(message.markers.size(), 2U);
  EXPECT_EQ(message.markers[0].id, id);
  EXPECT_EQ(message.markers[0].action, Marker::DELETE);
  EXPECT_TRUE(message.markers[0].points.empty());
  EXPECT_TRUE(message.markers[0].colors.empty());
  drawings.of("radio").line({1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}, colors::kRed);
  deviceMarkers(simulation->space(), drawings, message);
  EXPECT_EQ(message.markers[0].action, Marker::ADD);
  EXPECT_EQ(message.markers[0].points.size(), 2U);
}

}  // namespace
}  // namespace swarmanoid
