/// A partition of an area into square cells, for grids over it. Positions outside the area belong to the border cells.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>

namespace swarmanoid {

/// Index from 0 to count - 1 of the cell at a coordinate in cell widths, clamped; NaN gives cell 0.
inline int clampedCell(double cell, int count) {
  return cell >= count ? count - 1 : cell > 0.0 ? static_cast<int>(cell) : 0;
}

class CellLayout {
 public:
  /// One cell.
  CellLayout() = default;
  /// @param corner of the area, with its least coordinates [m] @param size of the area from there [m]
  /// @param smallest side of a cell [m]; larger if there would be more than `most_per_axis` cells along an axis
  CellLayout(const Eigen::Vector2d& corner, const Eigen::Vector2d& size, double smallest, double most_per_axis)
      : corner_(corner) {
    const double side = std::max(smallest, size.maxCoeff() / most_per_axis);
    inverse_side_ = 1.0 / side;
    columns_ = std::max(1, static_cast<int>(std::ceil(size.x() / side)));
    lines_ = std::max(1, static_cast<int>(std::ceil(size.y() / side)));
  }

  /// Index of the column at a coordinate [m].
  int column(double x) const { return clampedCell((x - corner_.x()) * inverse_side_, columns_); }
  int line(double y) const { return clampedCell((y - corner_.y()) * inverse_side_, lines_); }
  /// Index from 0 to count() - 1, line by line.
  std::size_t cell(int column, int line) const {
    return static_cast<std::size_t>(line) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }
  std::size_t count() const { return cell(0, lines_); }

 private:
  Eigen::Vector2d corner_ = Eigen::Vector2d::Zero();  // m
  double inverse_side_ = 1.0;                         // 1/m
  int columns_ = 1;
  int lines_ = 1;
};

}  // namespace swarmanoid
