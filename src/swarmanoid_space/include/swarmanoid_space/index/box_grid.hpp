/// A look-up of static boxes, such as walls, near a position: a grid of wide cells over the arena, each with a list of
/// the boxes that overlap it.
///
/// The cost of a look-up depends on the number of boxes near it, not on the number of walls. Boxes outside the arena
/// are in the border cells.
/// Threads: const functions may run concurrently.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <vector>

#include "swarmanoid_space/index/cell_layout.hpp"

namespace swarmanoid {

class BoxGrid {
 public:
  /// An unconfigured grid has one cell. @param corner of the area, with its least coordinates [m]
  /// @param size of the area from there [m]
  void configure(const Eigen::Vector2d& corner, const Eigen::Vector2d& size);
  void clear();

  /// Adds an item or replaces its box. @param item its number, from 0
  void set(std::int32_t item, const Eigen::AlignedBox2d& bounds);
  void remove(std::int32_t item);

  bool has(std::int32_t item) const {
    const auto place = static_cast<std::size_t>(item);
    return place < entry_of_item_.size() && entry_of_item_[place] != kNone;
  }
  bool isEmpty() const { return entries_.empty(); }

  /// @pre the item was added
  const Eigen::AlignedBox2d& bounds(std::int32_t item) const {
    return entries_[static_cast<std::size_t>(entry_of_item_[static_cast<std::size_t>(item)])].bounds;
  }

  /// Calls visit(item) once for each box within `radius` of `centre`, until it returns false.
  /// @return whether no call returned false
  template <class Visit>
  bool visitNear(const Eigen::Vector2d& centre, double radius, Visit visit) const {
    if (entries_.empty()) {
      return true;
    }
    const auto visitIfNear = [&](const Entry& entry) {
      return entry.bounds.squaredExteriorDistance(centre) > radius * radius || visit(entry.item);
    };
    const Eigen::Vector2d reach = Eigen::Vector2d::Constant(radius);
    const Cells cells = cellsOf({centre - reach, centre + reach});
    const int cell_count = (cells.high_column - cells.low_column + 1) * (cells.high_line - cells.low_line + 1);
    if (static_cast<int>(entries_.size()) < cell_count) {  // such as the few walls of an arena in a large search area
      return std::all_of(entries_.begin(), entries_.end(), visitIfNear);
    }
    for (int line = cells.low_line; line <= cells.high_line; ++line) {
      for (int column = cells.low_column; column <= cells.high_column; ++column) {
        for (const std::int32_t number : cells_[layout_.cell(column, line)]) {
          const Entry& entry = entries_[static_cast<std::size_t>(number)];
          // an entry in several cells counts only in the first of the cells that it shares with the search area
          const bool is_first = column == std::max(cells.low_column, entry.cells.low_column) &&
                                line == std::max(cells.low_line, entry.cells.low_line);
          if (is_first && !visitIfNear(entry)) {
            return false;
          }
        }
      }
    }
    return true;
  }

 private:
  static constexpr std::int32_t kNone = -1;

  struct Cells {
    int low_column;
    int high_column;
    int low_line;
    int high_line;
  };
  struct Entry {
    std::int32_t item;
    Eigen::AlignedBox2d bounds;
    Cells cells;
  };

  Cells cellsOf(const Eigen::AlignedBox2d& box) const {
    return {layout_.column(box.min().x()), layout_.column(box.max().x()), layout_.line(box.min().y()),
            layout_.line(box.max().y())};
  }
  template <class Visit>  // visit(list of the cell)
  void visitCells(const Cells& cells, Visit visit);

  CellLayout layout_;
  std::vector<Entry> entries_;
  std::vector<std::int32_t> entry_of_item_;          // by item; kNone: not in the grid
  std::vector<std::vector<std::int32_t>> cells_{1};  // entries
};

}  // namespace swarmanoid
