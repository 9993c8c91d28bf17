// Markers that are sent once: the fixed part of a space, and the bodies that tf moves.
#include "marker.hpp"
#include "swarmanoid_recording/messages/markers.hpp"
#include "swarmanoid_recording/messages/world_state.hpp"

namespace swarmanoid {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

/// Returns the parts of a rectangle that another one does not cover.
std::vector<Eigen::AlignedBox2d> around(const Eigen::AlignedBox2d& whole, const Eigen::AlignedBox2d& hole) {
  const Eigen::AlignedBox2d cut = whole.intersection(hole);
  if (cut.isEmpty()) {
    return {whole};
  }
  const Eigen::Vector2d& low = whole.min();
  const Eigen::Vector2d& high = whole.max();
  std::vector<Eigen::AlignedBox2d> parts;
  const auto add = [&](double x, double y, double to_x, double to_y) {
    if (to_x > x && to_y > y) {
      parts.emplace_back(Eigen::Vector2d(x, y), Eigen::Vector2d(to_x, to_y));
    }
  };
  add(low.x(), low.y(), high.x(), cut.min().y());
  add(low.x(), cut.max().y(), high.x(), high.y());
  add(low.x(), cut.min().y(), cut.min().x(), cut.max().y());
  add(cut.max().x(), cut.min().y(), high.x(), cut.max().y());
  return parts;
}

void drawFloor(const Space& space, const std_msgs::Header& header, MarkerArray& markers) {
  constexpr double kThickness = 0.01;
  constexpr double kBelowPatches = 0.002;  // [m]; enough distance to avoid flicker in rviz
  const Eigen::AlignedBox2d whole(Eigen::Vector2d(space.corner.head<2>()),
                                  Eigen::Vector2d(space.farCorner().head<2>()));
  std::vector<Eigen::AlignedBox2d> parts{whole};
  if (space.terrain) {
    const Eigen::AlignedBox3d& bounds = space.terrain->bounds();
    parts = around(whole, {Eigen::Vector2d(bounds.min().head<2>()), Eigen::Vector2d(bounds.max().head<2>())});
    markers.markers.push_back(terrainMarker(header, *space.terrain));
  }
  int part_id = 0;
  for (const Eigen::AlignedBox2d& part : parts) {
    const Eigen::Vector2d size = part.sizes();
    Marker floor = makeMarker(header, "floor", part_id++, Marker::CUBE, {size.x(), size.y(), kThickness},
                              rgba(0.82F, 0.83F, 0.85F, 1.0F));
    const Eigen::Vector2d middle = part.center();
    floor.pose.position = toMessage(Eigen::Vector3d(middle.x(), middle.y(), -0.5 * kThickness - kBelowPatches));
    markers.markers.push_back(floor);
  }
  Marker grid = gridMarker(header, space.size.head<2>(), parts);
  if (!grid.points.empty()) {
    markers.markers.push_back(std::move(grid));
  }
  addFloorColors(space, header, markers);
}

void drawEntity(const Space& space, Row row, const std_msgs::Header& header, int& id, MarkerArray& markers) {
  const EntityModel& model = *space.entities.model[row];
  const Pose& pose = space.entities.pose[row];
  const Color color = space.ownColor(row);
  if (model.shapes.empty()) {
    // a lamp
    constexpr double kDiameter = 0.08;
    Marker lamp = makeMarker(header, "lights", id++, Marker::SPHERE, Eigen::Vector3d::Constant(kDiameter),
                             color.isLit() ? opaque(color) : rgba(0.3F, 0.3F, 0.3F, 1.0F));
    lamp.pose = toMessage(pose);
    markers.markers.push_back(lamp);
  }
  const std_msgs::ColorRGBA grey = rgba(0.55F, 0.57F, 0.6F, 1.0F);
  const bool is_boundary = isBoundary(space, row);
  for (const CollisionShape& shape : model.shapes) {
    Marker marker = shapeMarker(header, is_boundary ? "boundary" : "obstacles", id++, shape, pose,
                                color.isLit() ? opaque(color) : grey);
    if (isOverhead(space, row, shape)) {
      constexpr float kTranslucent = 0.2F;
      marker.color.a = kTranslucent;
    }
    if (is_boundary) {
      // full walls of the arena would hide the events behind them: only their foot is drawn
      constexpr double kHeight = 0.1;
      marker.scale.z = kHeight;
      marker.pose.position.z = 0.5 * kHeight;
    }
    markers.markers.push_back(marker);
  }
}

}  // namespace

bool isBoundary(const Space& space, Row row) { return space.entities.name[row].rfind("boundary_", 0) == 0; }

bool isOverhead(const Space& space, Row row, const CollisionShape& shape) {
  const Pose& pose = space.entities.pose[row];
  const Eigen::Matrix3d orientation = (pose.orientation * shape.orientation).toRotationMatrix();
  const double middle = (pose.toWorld(shape.position)).z();
  return middle - orientation.row(2).cwiseAbs().dot(shape.half_extent) > 0.5 * space.farCorner().z();
}

MarkerArray arenaMarkers(const Space& space) {
  const std_msgs::Header header = headerOf(space);
  MarkerArray markers;
  Marker clear;
  clear.header = header;
  clear.action = Marker::DELETEALL;
  markers.markers.push_back(clear);
  drawFloor(space, header, markers);
  int id = 0;
  for (const Row row : space.entities.order) {
    if (!space.entities.model[row]->is_movable) {
      drawEntity(space, row, header, id, markers);
    }
  }
  addRobotBodies(space, markers);
  return markers;
}

}  // namespace swarmanoid
