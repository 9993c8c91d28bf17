/// Making markers.
#pragma once

#include <visualization_msgs/Marker.h>
#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

std_msgs::ColorRGBA rgba(float red, float green, float blue, float alpha);
/// Opaque, black too.
std_msgs::ColorRGBA opaque(Color color);

visualization_msgs::Marker makeMarker(const std_msgs::Header& header, const std::string& space_name, int id, int type,
                                      const Eigen::Vector3d& scale, const std_msgs::ColorRGBA& color);

/// A solid of an entity at `pose`.
visualization_msgs::Marker shapeMarker(const std_msgs::Header& header, const std::string& space_name, int id,
                                       const CollisionShape& shape, const Pose& pose, const std_msgs::ColorRGBA& color);

/// The terrain's surface, and the cliffs between its rim and the floor.
visualization_msgs::Marker terrainMarker(const std_msgs::Header& header, const Terrain& terrain);

/// The bodies of up to Transforms::kFewRobots robots as their URDF describes them, fixed to their frames: tf moves
/// them.
void addRobotBodies(const Space& space, visualization_msgs::MarkerArray& markers);

bool hasFewRobots(const Space& space);

}  // namespace swarmanoid
