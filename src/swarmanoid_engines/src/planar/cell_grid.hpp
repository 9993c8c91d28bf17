/// Broad phase for small bodies: a grid of cells over the arena. Each cell is a linked list of the bodies whose centre
/// is in it.
///
/// Moving a body to another cell takes a few writes; only `add` allocates. Bodies outside the arena are in the border
/// cells.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "swarmanoid_space/index/cell_layout.hpp"

namespace swarmanoid::planar {

class CellGrid {
 public:
  static constexpr std::int32_t kEnd = -1;

  /// @param corner of the area, with its smallest coordinates [m] @param size of the area from there [m]
  void configure(const Eigen::Vector2d& corner, const Eigen::Vector2d& size);

  void add(std::int32_t body, const Eigen::Vector2d& position);
  void remove(std::int32_t body);
  /// Whether `move` would change the body's cell.
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
    const int column_low = layout_.column(centre.x() - radius);
    const int column_high = layout_.column(centre.x() + radius);
    const int line_low = layout_.line(centre.y() - radius);
    const int line_high = layout_.line(centre.y() + radius);
    for (int line = line_low; line <= line_high; ++line) {
      for (int column = column_low; column <= column_high; ++column) {
        for (std::int32_t body = first_[layout_.cell(column, line)]; body != kEnd;
             body = next_[static_cast<std::size_t>(body)]) {
          if (!visit(body)) {
            return;
          }
        }
      }
    }
  }

 private:
  std::int32_t cellOf(const Eigen::Vector2d& p) const {
    return static_cast<std::int32_t>(layout_.cell(layout_.column(p.x()), layout_.line(p.y())));
  }
  void link(std::int32_t body, std::int32_t cell);
  void unlink(std::int32_t body);

  CellLayout layout_;
  std::vector<std::int32_t> first_{kEnd};  // by cell
  std::vector<std::int32_t> next_;         // by body
  std::vector<std::int32_t> previous_;     // by body
  std::vector<std::int32_t> cell_;         // by body
};

}  // namespace swarmanoid::planar
