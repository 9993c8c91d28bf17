/// Creates markers.
#pragma once

#include <visualization_msgs/Marker.h>
#include <visualization_msgs/MarkerArray.h>

#include <string>
#include <vector>

#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

std_msgs::ColorRGBA rgba(float red, float green, float blue, float alpha);
/// Returns an opaque colour, even for black.
std_msgs::ColorRGBA opaque(Color color);

visualization_msgs::Marker makeMarker(const std_msgs::Header& header, const std::string& space_name, int id, int type,
                                      const Eigen::Vector3d& scale, const std_msgs::ColorRGBA& color);

/// Sets the action to DELETE if the list is empty, and to ADD otherwise, because rviz warns of lists without points.
void deleteIfEmpty(visualization_msgs::Marker& list);

/// Marker of a solid of an entity at `pose`.
visualization_msgs::Marker shapeMarker(const std_msgs::Header& header, const std::string& space_name, int id,
                                       const CollisionShape& shape, const Pose& pose, const std_msgs::ColorRGBA& color);

/// Marker of the terrain's surface, and the cliffs between its rim and the floor.
visualization_msgs::Marker terrainMarker(const std_msgs::Header& header, const Terrain& terrain);

/// Adds the image and the patches of the floor.
void addFloorColors(const Space& space, const std_msgs::Header& header, visualization_msgs::MarkerArray& markers);

/// Marker of the paint on the floor, one square per cell, or fewer and larger squares for very many cells; without
/// points if no paint is visible.
visualization_msgs::Marker paintMarker(const Space& space, const std_msgs::Header& header);

/// Marker with lines around the cells of a floor of this size [m], in its level parts; without points if there are
/// none.
visualization_msgs::Marker gridMarker(const std_msgs::Header& header, const Eigen::Vector2d& size,
                                      const std::vector<Eigen::AlignedBox2d>& parts);

/// Adds each robot's name and state, readable when the whole arena is in sight, and lines from each robot's top to its
/// label, which may be moved aside to avoid overlaps.
void addLabels(const Space& space, const std_msgs::Header& header, visualization_msgs::MarkerArray& markers);

/// Adds the bodies of up to Transforms::kFewRobots robots as their URDF describes them, fixed to their frames, so that
/// tf moves them.
void addRobotBodies(const Space& space, visualization_msgs::MarkerArray& markers);

/// Returns whether the entity is a wall around the arena; only the foot of these walls is drawn.
bool isBoundary(const Space& space, Row row);

/// Returns whether a shape is in the upper half of the arena, like a ceiling, and would hide everything below it if it
/// were not translucent.
bool isOverhead(const Space& space, Row row, const CollisionShape& shape);

bool hasFewRobots(const Space& space);

}  // namespace swarmanoid
