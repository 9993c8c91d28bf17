/// Terrains for tests.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "swarmanoid_space/rays/terrain.hpp"

namespace swarmanoid::dynamics3d {

/// A square around (5, 5). @param height of places in W [m]; @param cell approximate length of a cell [m]; @param half
/// of its side [m]
inline std::shared_ptr<const Terrain> terrainOf(const std::function<double(double x, double y)>& height, double cell,
                                                double half = 1.0) {
  const int cells = static_cast<int>(std::lround(2.0 * half / cell));
  std::vector<double> heights;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      heights.push_back(height(5.0 - half + 2.0 * half * i / cells, 5.0 - half + 2.0 * half * j / cells));
    }
  }
  return std::make_shared<const Terrain>(Eigen::Vector2d::Constant(5.0 - half), Eigen::Vector2d::Constant(2.0 * half),
                                         cells + 1, cells + 1, std::move(heights));
}

}  // namespace swarmanoid::dynamics3d
