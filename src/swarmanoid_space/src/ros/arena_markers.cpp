// What is sent once: the part of a space that does not move, and the bodies that tf moves.
#include "marker.hpp"
#include "swarmanoid_space/ros/markers.hpp"
#include "swarmanoid_space/ros/world_state.hpp"

namespace swarmanoid {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

/// How thick patches are drawn, and how far the floor lies below them [m]: apart enough not to flicker in rviz.
constexpr double kPatchHeight = 0.002;

void drawFloor(const Space& space, const std_msgs::Header& header, MarkerArray& markers) {
  constexpr double kThickness = 0.01;
  Marker floor = makeMarker(header, "floor", 0, Marker::CUBE, {space.size.x(), space.size.y(), kThickness},
                            rgba(0.82F, 0.83F, 0.85F, 1.0F));
  floor.pose.position =
      toMessage(Eigen::Vector3d(0.5 * space.size.x(), 0.5 * space.size.y(), -0.5 * kThickness - kPatchHeight));
  markers.markers.push_back(floor);

  int id = 0;
  for (const FloorPatch& patch : space.floor_patches) {
    const bool is_disc = patch.radius > 0.0;
    const Eigen::Vector3d scale = is_disc ? Eigen::Vector3d(2.0 * patch.radius, 2.0 * patch.radius, kPatchHeight)
                                          : Eigen::Vector3d(patch.size.x(), patch.size.y(), kPatchHeight);
    Marker marker = makeMarker(header, "floor_patches", id++, is_disc ? Marker::CYLINDER : Marker::CUBE, scale,
                               opaque(patch.color));
    marker.pose.position = toMessage(patch.position);
    markers.markers.push_back(marker);
  }
}

void drawEntity(const Space& space, Row row, const std_msgs::Header& header, int& id, MarkerArray& markers) {
  const auto i = static_cast<std::size_t>(row);
  const EntityModel& model = *space.entities.model[i];
  const Pose& pose = space.entities.pose[i];
  const Color color = space.entities.color[i];
  if (model.shapes.empty()) {
    // a lamp
    constexpr double kDiameter = 0.08;
    Marker lamp = makeMarker(header, "lights", id++, Marker::SPHERE, Eigen::Vector3d::Constant(kDiameter),
                             color.isLit() ? opaque(color) : rgba(0.3F, 0.3F, 0.3F, 1.0F));
    lamp.pose = toMessage(pose);
    markers.markers.push_back(lamp);
  }
  const std_msgs::ColorRGBA grey = rgba(0.55F, 0.57F, 0.6F, 1.0F);
  const bool is_boundary = space.entities.name[i].rfind("boundary_", 0) == 0;
  for (const CollisionShape& shape : model.shapes) {
    Marker marker = shapeMarker(header, is_boundary ? "boundary" : "obstacles", id++, shape, pose,
                                color.isLit() ? opaque(color) : grey);
    if (is_boundary) {
      // the arena's own walls would hide what happens behind them: only their foot is drawn
      constexpr double kHeight = 0.1;
      marker.scale.z = kHeight;
      marker.pose.position.z = 0.5 * kHeight;
    }
    markers.markers.push_back(marker);
  }
}

}  // namespace

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
    if (!space.entities.model[static_cast<std::size_t>(row)]->is_movable) {
      drawEntity(space, row, header, id, markers);
    }
  }
  addRobotBodies(space, markers);
  return markers;
}

}  // namespace swarmanoid
