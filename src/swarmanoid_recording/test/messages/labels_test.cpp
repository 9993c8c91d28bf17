// Names and states of robots in rviz: readable in arenas of any size, without overlaps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_recording/messages/markers.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {
namespace {

using visualization_msgs::Marker;

/// Footbots at these places, and other entities, in a square arena.
std::vector<Marker> drawn(const std::string& name, double side, const std::vector<Eigen::Vector2d>& places,
                          const std::string& others = "") {
  std::string text =
      "<ahss-config><framework><clocktick>100</clocktick><maxclock>10</maxclock></framework><arena size=\"" +
      std::to_string(side) + ", " + std::to_string(side) + ", 1\" optimization=\"2D\">";
  for (std::size_t i = 0; i < places.size(); ++i) {
    text += "<footbot id=\"footbot_" + std::to_string(i) + "\"><position>" + std::to_string(places[i].x()) + ", " +
            std::to_string(places[i].y()) + ", 0</position><orientation>0, 0, 0</orientation></footbot>";
  }
  Simulation simulation(parseExperiment(text + others + "</arena></ahss-config>", "labels.xml"));
  simulation.start();
  MovingMarkers markers;
  std::vector<Marker> found;
  for (const Marker& marker : markers.draw(simulation.space()).markers) {
    if (marker.ns == name) {
      found.push_back(marker);
    }
  }
  return found;
}

/// A text in the picture of a camera that looks from the south and down by 0.85 rad.
struct Text {
  explicit Text(const Marker& label)
      : x(label.pose.position.x),
        y(label.pose.position.y * std::sin(0.85) + label.pose.position.z * std::cos(0.85)),
        // mean width of letters of Liberation Sans
        width(0.45 * label.scale.z * static_cast<double>(label.text.size())),
        height(label.scale.z) {}
  double x, y, width, height;
};

bool areOverlapping(const Text& a, const Text& b) {
  return std::abs(a.x - b.x) < 0.5 * (a.width + b.width) && std::abs(a.y - b.y) < 0.5 * (a.height + b.height);
}

void expectApart(const std::vector<Marker>& labels) {
  for (std::size_t i = 0; i < labels.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_FALSE(areOverlapping(Text(labels[i]), Text(labels[j]))) << labels[i].text << ", " << labels[j].text;
    }
  }
}

TEST(LabelsTest, TextGrowsWithTheArena) {
  const double small = drawn("labels", 3.0, {{1.0, 1.0}})[0].scale.z;
  EXPECT_GT(small, 0.02 * 3.0);
  EXPECT_GT(drawn("labels", 12.0, {{1.0, 1.0}})[0].scale.z, 3.0 * small);
}

TEST(LabelsTest, AreInTheirOwnPlaceWhereRobotsAreApart) {
  const std::vector<Eigen::Vector2d> places{{2.0, 2.0}, {2.0, 5.0}, {2.0, 8.0}, {6.0, 2.0}, {9.0, 2.0}};
  const std::vector<Marker> labels = drawn("labels", 12.0, places);
  ASSERT_EQ(labels.size(), places.size());
  expectApart(labels);
  for (const Marker& label : labels) {
    EXPECT_DOUBLE_EQ(label.pose.position.z, labels[0].pose.position.z);
  }
  const std::vector<Marker> lines = drawn("label_lines", 12.0, places);
  ASSERT_EQ(lines.size(), 1U);
  ASSERT_EQ(lines[0].points.size(), 2U * places.size());
  for (std::size_t i = 0; i < 2U * places.size(); i += 2) {
    EXPECT_DOUBLE_EQ(lines[0].points[i].x, lines[0].points[i + 1].x);
    EXPECT_LT(lines[0].points[i].z, lines[0].points[i + 1].z);
  }
}

TEST(LabelsTest, GiveWayToEachOtherWhereRobotsStandTogether) {
  std::vector<Eigen::Vector2d> places;
  for (int i = 0; i < 5; ++i) {
    places.emplace_back(1.0 + 0.2 * i, 2.0);
    places.emplace_back(8.0, 2.0 + 0.2 * i);
  }
  const std::vector<Marker> labels = drawn("labels", 12.0, places);
  ASSERT_EQ(labels.size(), places.size());
  expectApart(labels);
  const double lowest = drawn("labels", 12.0, {{1.0, 1.0}})[0].pose.position.z;
  for (const Marker& label : labels) {
    EXPECT_LT(label.pose.position.z, lowest + 2.5);  // not stacked above all the others
  }
}

TEST(LabelsTest, AreNotHiddenByAnObstacle) {
  // the label of the southernmost robot must avoid the other robots; it must move neither behind the cabinet on its
  // left, which would be closest, nor out of the arena on its right
  const std::string cabinet =
      "<block id=\"cabinet\"><position>1.3, 0.7, 0.5</position>"
      "<orientation>0, 0, 0</orientation><size>0.6, 0.6, 1</size></block>";
  const std::vector<Eigen::Vector2d> places{{1.8, 1.2}, {1.8, 1.35}, {1.8, 1.5}, {1.8, 1.65}};
  const auto first = [&](const std::vector<Marker>& labels) {
    return *std::find_if(labels.begin(), labels.end(), [](const Marker& one) { return one.text == "footbot_0"; });
  };
  const std::vector<Marker> labels = drawn("labels", 2.0, places, cabinet);
  expectApart(labels);
  EXPECT_DOUBLE_EQ(first(labels).pose.position.x, 1.8);
  EXPECT_LT(first(drawn("labels", 2.0, places)).pose.position.x, 1.6);
}

}  // namespace
}  // namespace swarmanoid
