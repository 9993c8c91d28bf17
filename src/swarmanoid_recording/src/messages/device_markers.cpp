// Drawings of devices, as one list of lines and one of points for each type: rviz shows and hides them by their names.
#include <utility>

#include "marker.hpp"
#include "swarmanoid_recording/messages/markers.hpp"
#include "swarmanoid_recording/messages/world_state.hpp"

namespace swarmanoid {
namespace {

using visualization_msgs::Marker;

constexpr int kLines = 0;  // ids
constexpr int kPoints = 1;

/// Clears the points and colours of a list, keeping their memory.
void beginList(const std_msgs::Header& header, const std::string& type, int id, Marker& marker) {
  constexpr double kWidth = 0.005;  // of lines, m
  constexpr double kSide = 0.025;   // of points, m
  Marker list = makeMarker(header, "devices/" + type, id, id == kLines ? Marker::LINE_LIST : Marker::POINTS,
                           id == kLines ? Eigen::Vector3d(kWidth, 0.0, 0.0) : Eigen::Vector3d(kSide, kSide, 0.0),
                           rgba(1.0F, 1.0F, 1.0F, 1.0F));
  list.points.swap(marker.points);
  list.points.clear();
  list.colors.swap(marker.colors);
  list.colors.clear();
  marker = std::move(list);
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
    deleteIfEmpty(lines);
    Marker& points = next();
    beginList(header, type, kPoints, points);
    drawPoints(drawing, points);
    deleteIfEmpty(points);
  }
  message.markers.resize(count);
}

}  // namespace swarmanoid
