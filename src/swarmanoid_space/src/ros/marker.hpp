/// Making markers.
#pragma once

#include <visualization_msgs/Marker.h>
#include <visualization_msgs/MarkerArray.h>

#include <string>
#include <vector>

#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

std_msgs::ColorRGBA rgba(float red, float green, float blue, float alpha);
/// Opaque, black too.
std_msgs::ColorRGBA opaque(Color color);

visualization_msgs::Marker makeMarker(const std_msgs::Header& header, const std::string& space_name, int id, int type,
                                      const Eigen::Vector3d& scale, const std_msgs::ColorRGBA& color);

/// rviz complains of lists without points: adds the list or, where it has none, deletes it.
void deleteIfEmpty(visualization_msgs::Marker& list);

/// A solid of an entity at `pose`.
visualization_msgs::Marker shapeMarker(const std_msgs::Header& header, const std::string& space_name, int id,
                                       const CollisionShape& shape, const Pose& pose, const std_msgs::ColorRGBA& color);

/// The terrain's surface, and the cliffs between its rim and the floor.
visualization_msgs::Marker terrainMarker(const std_msgs::Header& header, const Terrain& terrain);

/// The image and the patches of the floor.
void addFloorColors(const Space& space, const std_msgs::Header& header, visualization_msgs::MarkerArray& markers);

/// The paint on the floor, by its cells, or by fewer and larger squares where there are very many; without points if
/// there is none to be seen.
visualization_msgs::Marker paintMarker(const Space& space, const std_msgs::Header& header);

/// Lines around the cells of a floor of this size [m], in those parts of it that are level; without points where none
/// is.
visualization_msgs::Marker gridMarker(const std_msgs::Header& header, const Eigen::Vector2d& size,
                                      const std::vector<Eigen::AlignedBox2d>& parts);

/// Each robot's name and state, readable when the whole arena is in sight, and lines, each from a robot's top to its
/// label, which may have had to give way to others.
void addLabels(const Space& space, const std_msgs::Header& header, visualization_msgs::MarkerArray& markers);

/// The bodies of up to Transforms::kFewRobots robots as their URDF describes them, fixed to their frames: tf moves
/// them.
void addRobotBodies(const Space& space, visualization_msgs::MarkerArray& markers);

/// A wall around the arena, of which only the foot is drawn.
bool isBoundary(const Space& space, Row row);

/// Whether a shape hangs in the upper half of the arena, as a ceiling does, and would hide everything below it if it
/// were not translucent.
bool isOverhead(const Space& space, Row row, const CollisionShape& shape);

bool hasFewRobots(const Space& space);

}  // namespace swarmanoid
