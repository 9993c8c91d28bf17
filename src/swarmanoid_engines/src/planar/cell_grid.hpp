/// Which small bodies are near a place: a grid of cells over the arena, each a linked list of the bodies whose centre
/// is in it.
///
/// Moving a body to another cell is a few writes; nothing is allocated but when bodies are added. What is outside the
/// arena is kept in the border cells.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace swarmanoid::planar {

class CellGrid {
 public:
  static constexpr std::int32_t kEnd = -1;

  /// @param size of the area, which spans from 0 to size [m]
  void configure(const Eigen::Vector2d& size);

  void add(std::int32_t body, const Eigen::Vector2d& position);
  void remove(std::int32_t body);
  /// Whether `move` would put it into another cell.
  bool isElsewhere(std::int32_t body, const Eigen::Vector2d& position) const {
    return cellOf(position) != cell_[static_cast<std::size_t>(body)];
  }
  void move(std::int32_t body, const Eigen::Vector2d& position) {
    const std::int32_t cell = cellOf(position);
    if (cell != cell_[static_cast<std::size_t>(body)]) {
      unlink(body);
      link(body, cell);
    }
  }
  void clear();

  /// Calls visit(body) for all bodies whose centre may be within `radius` of `centre`, until it returns false.
  template <class Visit>
  void visitNear(const Eigen::Vector2d& centre, double radius, Visit visit) const {
    const int column_low = clamped((centre.x() - radius) * inverse_cell_size_, columns_);
    const int column_high = clamped((centre.x() + radius) * inverse_cell_size_, columns_);
    const int line_low = clamped((centre.y() - radius) * inverse_cell_size_, lines_);
    const int line_high = clamped((centre.y() + radius) * inverse_cell_size_, lines_);
    for (int line = line_low; line <= line_high; ++line) {
      for (int column = column_low; column <= column_high; ++column) {
        const std::size_t cell =
            static_cast<std::size_t>(line) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
        for (std::int32_t body = first_[cell]; body != kEnd; body = next_[static_cast<std::size_t>(body)]) {
          if (!visit(body)) {
            return;
          }
        }
      }
    }
  }

 private:
  static int clamped(double cell, int count) {
    // written so that NaN ends in cell 0
    return cell >= count ? count - 1 : cell > 0.0 ? static_cast<int>(cell) : 0;
  }
  std::int32_t cellOf(const Eigen::Vector2d& p) const {
    return clamped(p.y() * inverse_cell_size_, lines_) * columns_ + clamped(p.x() * inverse_cell_size_, columns_);
  }
  void link(std::int32_t body, std::int32_t cell);
  void unlink(std::int32_t body);

  double inverse_cell_size_ = 1.0;
  int columns_ = 1;
  int lines_ = 1;
  std::vector<std::int32_t> first_{kEnd};  // by cell
  std::vector<std::int32_t> next_;         // by body
  std::vector<std::int32_t> previous_;     // by body
  std::vector<std::int32_t> cell_;         // by body
};

}  // namespace swarmanoid::planar
