// Drawings of engines, as one list of lines for each engine and kind.
#include "marker.hpp"
#include "swarmanoid_recording/messages/markers.hpp"
#include "swarmanoid_recording/messages/world_state.hpp"

namespace swarmanoid {
namespace {

using Kind = EngineDrawing::Kind;
using visualization_msgs::Marker;

struct Look {
  Kind kind;
  const char* name;
  std_msgs::ColorRGBA color;
};

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
        marker.points.push_back(toMessage(from));
        marker.points.push_back(toMessage(to));
      }
      deleteIfEmpty(marker);
      message.markers.push_back(marker);
    }
  }
  return message;
}

}  // namespace swarmanoid
