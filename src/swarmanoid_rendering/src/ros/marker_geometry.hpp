/// Converts markers to geometry, as rviz draws them.
#pragma once

#include <visualization_msgs/Marker.h>

#include "../mesh_files.hpp"
#include "swarmanoid_rendering/geometry.hpp"

namespace swarmanoid {

/// Texts, and markers with another action than ADD, add nothing.
/// @param frame of the marker, in the world
/// @throws std::runtime_error for a mesh that cannot be read
void addMarker(const visualization_msgs::Marker& marker, const Eigen::Isometry3d& frame, MeshFiles& meshes,
               Geometry& geometry);

}  // namespace swarmanoid
