#include "read_terrain.hpp"

#include "read_png.hpp"

namespace swarmanoid {

Terrain readTerrain(const std::string& file, const Eigen::Vector3d& middle, const Eigen::Vector2d& size,
                    double height) {
  const GreyImage image = readGreyPng(file);
  std::vector<double> heights;
  heights.reserve(image.values.size());
  for (int row = image.rows - 1; row >= 0; --row) {
    for (int column = 0; column < image.columns; ++column) {
      const auto at =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(image.columns) + static_cast<std::size_t>(column);
      heights.push_back(middle.z() + height * image.values[at] / image.white);
    }
  }
  return {middle.head<2>() - 0.5 * size, size, image.columns, image.rows, std::move(heights)};
}

}  // namespace swarmanoid
