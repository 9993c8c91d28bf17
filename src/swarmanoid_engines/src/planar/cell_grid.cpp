#include "planar/cell_grid.hpp"

namespace swarmanoid::planar {

void CellGrid::configure(const Eigen::Vector2d& corner, const Eigen::Vector2d& size) {
  constexpr double kSmallestCell = 0.6;  // m: a footbot and its sensor range; in a crowd, a cell holds some four robots
  constexpr double kMostPerAxis = 2048.0;
  layout_ = CellLayout(corner, size, kSmallestCell, kMostPerAxis);
  clear();
}

void CellGrid::clear() {
  first_.assign(layout_.count(), kEnd);
  next_.clear();
  previous_.clear();
  cell_.clear();
}

void CellGrid::add(std::int32_t body, const Eigen::Vector2d& position) {
  const std::size_t needed = static_cast<std::size_t>(body) + 1;
  if (next_.size() < needed) {
    next_.resize(needed, kEnd);
    previous_.resize(needed, kEnd);
    cell_.resize(needed, kEnd);
  }
  link(body, cellOf(position));
}

void CellGrid::remove(std::int32_t body) { unlink(body); }

void CellGrid::link(std::int32_t body, std::int32_t cell) {
  const auto i = static_cast<std::size_t>(body);
  std::int32_t& first = first_[static_cast<std::size_t>(cell)];
  next_[i] = first;
  previous_[i] = kEnd;
  cell_[i] = cell;
  if (first != kEnd) {
    previous_[static_cast<std::size_t>(first)] = body;
  }
  first = body;
}

void CellGrid::unlink(std::int32_t body) {
  const auto i = static_cast<std::size_t>(body);
  if (previous_[i] != kEnd) {
    next_[static_cast<std::size_t>(previous_[i])] = next_[i];
  } else {
    first_[static_cast<std::size_t>(cell_[i])] = next_[i];
  }
  if (next_[i] != kEnd) {
    previous_[static_cast<std::size_t>(next_[i])] = previous_[i];
  }
}

}  // namespace swarmanoid::planar
