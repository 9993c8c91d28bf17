// What devices do, as one list of lines and one of points for each type: rviz shows and hides them by their names.
#include "marker.hpp"
#include "swarmanoid_space/ros/markers.hpp"
#include "swarmanoid_space/ros/world_state.hpp"

namespace swarmanoid {
namespace {

using visualization_msgs::Marker;

constexpr int kLines = 0;  // ids
constexpr int kPoints = 1;

/// Everything but points and colours, whose room is kept.
void beginList(const std_msgs::Header& header, const std::string& type, int id, Marker& marker) {
  constexpr double kWidth = 0.005;  // of lines, m
  constexpr double kSide = 0.025;   // of points, m
  marker.header = header;
  marker.ns = "devices/";
  marker.ns += type;
  marker.id = id;
  marker.type = id == kLines ? static_cast<int>(Marker::LINE_LIST) : static_cast<int>(Marker::POINTS);
  marker.pose.orientation.w = 1.0;
  marker.scale.x = id == kLines ? kWidth : kSide;
  marker.scale.y = id == kLines ? 0.0 : kSide;
  marker.color = rgba(1.0F, 1.0F, 1.0F, 1.0F);
  marker.points.clear();
  marker.colors.clear();
}

/// rviz complains of lists without points.
void endList(Marker& marker) {
  marker.action = marker.points.empty() ? static_cast<int>(Marker::DELETE) : static_cast<int>(Marker::ADD);
}

void drawLines(const DeviceDrawing& drawing, Marker& marker) {
  for (const DeviceDrawing::Line& line : drawing.lines()) {
    const std_msgs::ColorRGBA color = opaque(line.color);
    marker.points.push_back(toMessage(line.from));
    marker.points.push_back(toMessage(line.to));
    marker.colors.push_back(color);
    marker.colors.push_back(color);
  }
}

void drawPoints(const DeviceDrawing& drawing, Marker& marker) {
  for (const DeviceDrawing::Point& point : drawing.points()) {
    marker.points.push_back(toMessage(point.place));
    marker.colors.push_back(opaque(point.color));
  }
}

}  // namespace

void deviceMarkers(const Space& space, const DeviceDrawings& drawings, visualization_msgs::MarkerArray& message) {
  const std_msgs::Header header = headerOf(space);
  std::size_t count = 0;
  const auto next = [&]() -> Marker& {
    if (count == message.markers.size()) {
      message.markers.emplace_back();
    }
    return message.markers[count++];
  };
  for (const auto& [type, drawing] : drawings.all()) {
    if (!drawing.isUsed()) {
      continue;
    }
    Marker& lines = next();
    beginList(header, type, kLines, lines);
    drawLines(drawing, lines);
    endList(lines);
    Marker& points = next();
    beginList(header, type, kPoints, points);
    drawPoints(drawing, points);
    endList(points);
  }
  message.markers.resize(count);
}

}  // namespace swarmanoid
