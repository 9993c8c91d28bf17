#include "swarmanoid_space/rays/terrain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace swarmanoid {

Terrain::Terrain(const Eigen::Vector2d& low, const Eigen::Vector2d& size, int columns, int rows,
                 std::vector<double> heights)
    : columns_(columns), rows_(rows), heights_(std::move(heights)) {
  constexpr int kFewestPoints = 2;
  if (columns < kFewestPoints || rows < kFewestPoints || !(size.minCoeff() > 0.0) ||
      heights_.size() != static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {
    throw std::invalid_argument("a terrain needs a size, at least 2 x 2 vertices, and a height for each");
  }
  step_ = {size.x() / (columns - 1), size.y() / (rows - 1)};
  const auto [lowest, highest] = std::minmax_element(heights_.begin(), heights_.end());
  bounds_ = {Eigen::Vector3d(low.x(), low.y(), *lowest),
             Eigen::Vector3d(low.x() + size.x(), low.y() + size.y(), *highest)};
}

Eigen::Vector2i Terrain::cellAt(double x, double y) const {
  const auto cellOf = [](double place, double step, int cells) {
    return static_cast<int>(std::clamp(std::floor(place / step), 0.0, static_cast<double>(cells - 1)));
  };
  return {cellOf(x - bounds_.min().x(), step_.x(), columns_ - 1), cellOf(y - bounds_.min().y(), step_.y(), rows_ - 1)};
}

double Terrain::heightInCell(const Eigen::Vector2i& cell, double x, double y, int half) const {
  const int i = cell.x();
  const int j = cell.y();
  const double u = (x - lineX(i)) / step_.x();
  const double v = (y - lineY(j)) / step_.y();
  const double low = height(i, j);
  const double high = height(i + 1, j + 1);
  if (half == 0) {
    const double side = height(i + 1, j);
    return low + (side - low) * u + (high - side) * v;
  }
  const double side = height(i, j + 1);
  return low + (side - low) * v + (high - side) * u;
}

double Terrain::heightAt(double x, double y) const {
  const Eigen::Vector2i cell = cellAt(x, y);
  const bool is_first = (x - lineX(cell.x())) * step_.y() >= (y - lineY(cell.y())) * step_.x();
  return heightInCell(cell, x, y, is_first ? 0 : 1);
}

Terrain::Triangle Terrain::triangle(int i, int j, int half) const {
  Triangle result;
  result.corners[0] = vertex(i, j);
  result.corners[1] = half == 0 ? vertex(i + 1, j) : vertex(i + 1, j + 1);
  result.corners[2] = half == 0 ? vertex(i + 1, j + 1) : vertex(i, j + 1);
  result.normal = (result.corners[1] - result.corners[0]).cross(result.corners[2] - result.corners[0]).normalized();
  return result;
}

Terrain::Triangle Terrain::triangleAt(double x, double y) const {
  const Eigen::Vector2i cell = cellAt(x, y);
  const bool is_first = (x - lineX(cell.x())) * step_.y() >= (y - lineY(cell.y())) * step_.x();
  return triangle(cell.x(), cell.y(), is_first ? 0 : 1);
}

Terrain::Cells Terrain::cellsIn(const Eigen::Vector2d& low, const Eigen::Vector2d& high) const {
  if (low.x() > bounds_.max().x() || low.y() > bounds_.max().y() || high.x() < bounds_.min().x() ||
      high.y() < bounds_.min().y()) {
    return {};
  }
  return {cellAt(low.x(), low.y()), cellAt(high.x(), high.y())};
}

double Terrain::highestIn(const Cells& cells) const {
  double highest = -std::numeric_limits<double>::infinity();
  if (cells.high.x() < 0) {
    return highest;
  }
  for (int j = cells.low.y(); j <= cells.high.y() + 1; ++j) {
    for (int i = cells.low.x(); i <= cells.high.x() + 1; ++i) {
      highest = std::max(highest, height(i, j));
    }
  }
  return highest;
}

}  // namespace swarmanoid
