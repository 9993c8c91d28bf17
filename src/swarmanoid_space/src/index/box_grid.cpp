#include "swarmanoid_space/index/box_grid.hpp"

#include <algorithm>

#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid {

void BoxGrid::configure(const Eigen::Vector2d& corner, const Eigen::Vector2d& size) {
  constexpr double kSmallestCell = 1.0;  // m: more than the usual radius of queries by robots
  constexpr double kMostPerAxis = 256.0;
  layout_ = CellLayout(corner, size, kSmallestCell, kMostPerAxis);
  clear();
}

void BoxGrid::clear() {
  entries_.clear();
  entry_of_item_.clear();
  cells_.assign(layout_.count(), {});
}

template <class Visit>
void BoxGrid::visitCells(const Cells& cells, Visit visit) {
  for (int line = cells.low_line; line <= cells.high_line; ++line) {
    for (int column = cells.low_column; column <= cells.high_column; ++column) {
      visit(cells_[layout_.cell(column, line)]);
    }
  }
}

void BoxGrid::set(std::int32_t item, const Eigen::AlignedBox2d& bounds) {
  const auto place = static_cast<std::size_t>(item);
  if (has(item)) {
    remove(item);
  }
  entry_of_item_.resize(std::max(entry_of_item_.size(), place + 1), kNone);
  const auto number = static_cast<std::int32_t>(entries_.size());
  entry_of_item_[place] = number;
  entries_.push_back({item, bounds, cellsOf(bounds)});
  visitCells(entries_.back().cells, [&](std::vector<std::int32_t>& cell) { cell.push_back(number); });
}

void BoxGrid::remove(std::int32_t item) {
  std::int32_t& number = entry_of_item_[static_cast<std::size_t>(item)];
  SWARMANOID_EXPECTS(number != kNone);
  visitCells(entries_[static_cast<std::size_t>(number)].cells,
             [&](std::vector<std::int32_t>& cell) { cell.erase(std::find(cell.begin(), cell.end(), number)); });
  // the last entry moves to the free place
  const auto last = static_cast<std::int32_t>(entries_.size()) - 1;
  if (number != last) {
    const Entry moved = entries_.back();
    visitCells(moved.cells,
               [&](std::vector<std::int32_t>& cell) { *std::find(cell.begin(), cell.end(), last) = number; });
    entries_[static_cast<std::size_t>(number)] = moved;
    entry_of_item_[static_cast<std::size_t>(moved.item)] = number;
  }
  entries_.pop_back();
  number = kNone;
}

}  // namespace swarmanoid
