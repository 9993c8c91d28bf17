// What engines see, as one list of lines for each engine and kind.
#include "marker.hpp"
#include "swarmanoid_space/ros/markers.hpp"
#include "swarmanoid_space/ros/world_state.hpp"

namespace swarmanoid {
namespace {

using Kind = EngineDrawing::Kind;
using visualization_msgs::Marker;

struct Look {
  Kind kind;
  const char* name;
  std_msgs::ColorRGBA color;
};

void addPoint(const Eigen::Vector3d& place, Marker& marker) {
  geometry_msgs::Point point;
  point.x = place.x();
  point.y = place.y();
  point.z = place.z();
  marker.points.push_back(point);
}

}  // namespace

visualization_msgs::MarkerArray engineMarkers(const Space& space) {
  constexpr double kWidth = 0.004;  // m
  const Look looks[] = {{Kind::kShape, "shapes", rgba(0.9F, 0.9F, 0.9F, 0.7F)},
                        {Kind::kContact, "contacts", rgba(1.0F, 0.2F, 0.1F, 1.0F)},
                        {Kind::kJoint, "joints", rgba(1.0F, 0.8F, 0.1F, 1.0F)},
                        {Kind::kForce, "forces", rgba(0.2F, 0.9F, 0.3F, 1.0F)}};
  visualization_msgs::MarkerArray message;
  EngineDrawing drawing;
  for (const Engine* engine : space.engines) {
    drawing.clear();
    engine->draw(drawing);
    for (const Look& look : looks) {
      Marker marker = makeMarker(headerOf(space), "engines/" + engine->id() + "/" + look.name, 0, Marker::LINE_LIST,
                                 {kWidth, 0.0, 0.0}, look.color);
      for (const auto& [from, to] : drawing.lines(look.kind)) {
        addPoint(from, marker);
        addPoint(to, marker);
      }
      // rviz complains of lists without points
      marker.action = marker.points.empty() ? static_cast<int>(Marker::DELETE) : static_cast<int>(Marker::ADD);
      message.markers.push_back(marker);
    }
  }
  return message;
}

}  // namespace swarmanoid
