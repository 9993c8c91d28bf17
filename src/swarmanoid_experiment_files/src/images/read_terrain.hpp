/// Reads heightfields from images.
#pragma once

#include <Eigen/Core>
#include <string>

#include "swarmanoid_space/rays/terrain.hpp"

namespace swarmanoid {

/// Reads a terrain from a grey PNG image of 8 or 16 bits: its columns along x, its first row at the greatest y, the
/// outermost pixels on the rectangle's border. Grey values are linear; gamma is ignored.
/// @param middle of the rectangle, at the height of black [m]; @param height of white over black [m]
/// @throws std::runtime_error with the mistake in the file, such as "is no PNG image"
Terrain readTerrain(const std::string& file, const Eigen::Vector3d& middle, const Eigen::Vector2d& size, double height);

}  // namespace swarmanoid
