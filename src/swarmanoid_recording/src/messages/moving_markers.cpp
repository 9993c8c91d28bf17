// Markers of the part of a space that moves, shines or holds on to something.
#include <map>

#include "marker.hpp"
#include "swarmanoid_recording/messages/markers.hpp"
#include "swarmanoid_recording/messages/world_state.hpp"

namespace swarmanoid {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

/// State of one drawing.
struct Canvas {
  const Space& space;
  std_msgs::Header header;
  bool has_few_robots;
  MarkerArray& array;

  const Pose& poseOf(Row row) const { return space.entities.pose[row]; }
  const EntityModel& modelOf(Row row) const { return *space.entities.model[row]; }
  /// Adds a list unless it is empty: rviz warns of lists without points.
  void addList(Marker list) const {
    if (!list.points.empty()) {
      array.markers.push_back(std::move(list));
    }
  }
};

void drawSwarm(const Canvas& canvas) {
  constexpr double kLineWidth = 0.03;
  std::map<std::string, Marker> list_of_type;
  Marker headings = makeMarker(canvas.header, "headings", 0, Marker::LINE_LIST, {kLineWidth, 0.0, 0.0},
                               rgba(0.9F, 0.45F, 0.05F, 1.0F));
  for (const Row row : canvas.space.entities.order) {
    const EntityModel& model = canvas.modelOf(row);
    if (!model.is_robot) {
      continue;
    }
    const double diameter = 2.0 * (model.shapes.empty() ? 0.1 : model.shapes.front().half_extent.x());
    auto [list, is_new] = list_of_type.try_emplace(model.type);
    if (is_new) {
      list->second = makeMarker(canvas.header, "robots/" + model.type, 0, Marker::SPHERE_LIST,
                                Eigen::Vector3d::Constant(diameter), rgba(0.35F, 0.45F, 0.75F, 1.0F));
    }
    const double middle = 0.5 * (model.lowest + model.highest);
    list->second.points.push_back(toMessage(canvas.poseOf(row).toWorld({0.0, 0.0, middle})));
    headings.points.push_back(toMessage(canvas.poseOf(row).toWorld({0.0, 0.0, model.highest})));
    headings.points.push_back(toMessage(canvas.poseOf(row).toWorld({diameter, 0.0, middle})));
  }
  canvas.addList(std::move(headings));
  for (auto& [type, list] : list_of_type) {
    canvas.addList(std::move(list));
  }
}

void drawPreys(const Canvas& canvas) {
  for (const Row row : canvas.space.entities.order) {
    const EntityModel& model = canvas.modelOf(row);
    if (model.is_robot || !model.is_movable) {
      continue;
    }
    const Color color = canvas.space.ownColor(row);
    for (std::size_t k = 0; k < model.shapes.size(); ++k) {
      canvas.array.markers.push_back(shapeMarker(
          canvas.header, "preys/" + std::to_string(k), static_cast<int>(canvas.space.entities.number[row]),
          model.shapes[k], canvas.poseOf(row), color.isLit() ? opaque(color) : rgba(0.6F, 0.6F, 0.6F, 1.0F)));
    }
  }
}

void drawLeds(const Canvas& canvas) {
  constexpr double kDiameter = 0.025;
  Marker leds = makeMarker(canvas.header, "leds", 0, Marker::SPHERE_LIST, Eigen::Vector3d::Constant(kDiameter),
                           rgba(1.0F, 1.0F, 1.0F, 1.0F));
  for (const Row row : canvas.space.entities.order) {
    const EntityModel& model = canvas.modelOf(row);
    for (std::size_t led = 0; model.is_robot && led < model.led_positions.size(); ++led) {
      const Color color = canvas.space.leds[row][led];
      if (color.isLit()) {
        leds.points.push_back(toMessage(canvas.poseOf(row).toWorld(model.led_positions[led])));
        leds.colors.push_back(opaque(color));
      }
    }
  }
  canvas.addList(std::move(leds));
}

void drawLasers(const Canvas& canvas) {
  constexpr double kSpotDiameter = 0.06;
  constexpr double kBeamWidth = 0.006;
  Marker beams = makeMarker(canvas.header, "laser_beams", 0, Marker::LINE_LIST, {kBeamWidth, 0.0, 0.0},
                            rgba(1.0F, 0.0F, 0.0F, 0.6F));
  Marker spots = makeMarker(canvas.header, "laser_spots", 0, Marker::SPHERE_LIST,
                            {kSpotDiameter, kSpotDiameter, 0.2 * kSpotDiameter}, rgba(1.0F, 1.0F, 1.0F, 1.0F));
  for (const LaserSpot& spot : canvas.space.laser_spots) {
    beams.points.push_back(toMessage(spot.source));
    beams.points.push_back(toMessage(spot.position));
    spots.points.push_back(toMessage(spot.position));
    spots.colors.push_back(opaque(spot.color));
  }
  canvas.addList(std::move(beams));
  canvas.addList(std::move(spots));
}

void drawGrips(const Canvas& canvas) {
  constexpr double kWidth = 0.012;
  Marker grips =
      makeMarker(canvas.header, "grips", 0, Marker::LINE_LIST, {kWidth, 0.0, 0.0}, rgba(1.0F, 0.6F, 0.0F, 1.0F));
  for (const Row row : canvas.space.entities.order) {
    const Row gripped = canvas.space.structure.grippedBy(row);
    if (gripped == kNoRow) {
      continue;
    }
    // above both bodies, so that neither hides the line
    const auto top = [&](Row of) {
      return toMessage(canvas.poseOf(of).toWorld({0.0, 0.0, canvas.modelOf(of).highest + 0.02}));
    };
    grips.points.push_back(top(row));
    grips.points.push_back(top(gripped));
  }
  canvas.addList(std::move(grips));
}

void drawRopes(const Canvas& canvas) {
  constexpr double kWidth = 0.008;
  Marker ropes =
      makeMarker(canvas.header, "ropes", 0, Marker::LINE_LIST, {kWidth, 0.0, 0.0}, rgba(0.95F, 0.8F, 0.2F, 1.0F));
  for (const Row row : canvas.space.entities.order) {
    canvas.space.attachments.visit(row, [&](std::size_t index, const Attachment& rope) {
      const EntityModel::Holder& holder = canvas.modelOf(row).holders[index];
      if (holder.kind == EntityModel::Holder::Kind::kRope) {
        ropes.points.push_back(toMessage(canvas.poseOf(row).toWorld(canvas.modelOf(row).mount(holder.mount).position)));
        ropes.points.push_back(toMessage(canvas.poseOf(rope.held).toWorld(rope.anchor)));
      }
    });
  }
  canvas.addList(std::move(ropes));
}

}  // namespace

const MarkerArray& MovingMarkers::draw(const Space& space) {
  message_.markers.clear();
  const Canvas canvas{space, headerOf(space), hasFewRobots(space), message_};
  if (canvas.has_few_robots) {
    addLabels(space, canvas.header, message_);
  } else {
    drawSwarm(canvas);
  }
  canvas.addList(paintMarker(space, canvas.header));
  drawPreys(canvas);
  drawLeds(canvas);
  drawLasers(canvas);
  drawGrips(canvas);
  drawRopes(canvas);

  std::set<std::pair<std::string, int>> drawn;
  for (const Marker& marker : message_.markers) {
    drawn.emplace(marker.ns, marker.id);
  }
  for (const auto& [name, id] : shown_) {
    if (drawn.count({name, id}) == 0) {
      Marker gone;
      gone.header = canvas.header;
      gone.ns = name;
      gone.id = id;
      gone.action = Marker::DELETE;
      message_.markers.push_back(gone);
    }
  }
  shown_ = std::move(drawn);
  return message_;
}

}  // namespace swarmanoid
