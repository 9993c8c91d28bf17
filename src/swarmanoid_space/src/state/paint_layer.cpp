#include "swarmanoid_space/state/paint_layer.hpp"

#include <xxhash.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid {
namespace {

constexpr double kInvisible = 1.0 / 512.0;  // half a step of an 8-bit colour
constexpr double kMostHalfLives = 64.0;     // after this many a strength of 1 is 0

/// Interpolates the channel of a colour.
std::uint8_t between(std::uint8_t from, std::uint8_t to, double part) {
  return static_cast<std::uint8_t>(std::lround(from + part * (to - from)));
}

Color between(Color from, Color to, double part) {
  return {between(from.red, to.red, part), between(from.green, to.green, part), between(from.blue, to.blue, part)};
}

std::size_t cellsAlong(double length, double cell) { return static_cast<std::size_t>(std::ceil(length / cell)); }

/// Returns the cell of a coordinate in the arena, measured from the arena's corner.
std::size_t cellAt(double coordinate, double cell, std::size_t count) {
  return std::min(static_cast<std::size_t>(coordinate / cell), count - 1);
}

}  // namespace

PaintLayer::PaintLayer(const Eigen::Vector2d& size, double cell, double half_life, const Eigen::Vector2d& corner)
    : corner_(corner),
      size_(size),
      cell_size_(cell),
      columns_(cellsAlong(size.x(), cell)),
      rows_(cellsAlong(size.y(), cell)) {
  SWARMANOID_EXPECTS(cellsFor(size, cell) <= static_cast<double>(kMostCells));
  cells_.resize(columns_ * rows_);
  fade_.fill(1.0);
  if (half_life > 0.0) {
    vanishes_after_ = static_cast<std::uint64_t>(std::ceil(kMostHalfLives * half_life));
    fade_[0] = std::exp2(-1.0 / half_life);
    for (std::size_t i = 1; i < fade_.size(); ++i) {
      fade_[i] = fade_[i - 1] * fade_[i - 1];
    }
  }
}

double PaintLayer::cellsFor(const Eigen::Vector2d& size, double cell) {
  return std::ceil(size.x() / cell) * std::ceil(size.y() / cell);
}

double PaintLayer::strengthOf(const Cell& cell, std::uint64_t tick) const {
  std::uint64_t age = tick - cell.tick;
  if (vanishes_after_ == 0 || age == 0) {
    return cell.strength;
  }
  if (age >= vanishes_after_) {
    return 0.0;
  }
  double strength = cell.strength;
  for (std::size_t bit = 0; age != 0; ++bit, age >>= 1U) {
    if ((age & 1U) != 0) {
      strength *= fade_[bit];
    }
  }
  return strength;
}

Color PaintLayer::blend(Color floor, const Eigen::Vector2d& point, std::uint64_t tick) const {
  const Eigen::Vector2d from_corner = point - corner_;
  if (!(from_corner.x() >= 0.0 && from_corner.y() >= 0.0 && from_corner.x() <= size_.x() &&
        from_corner.y() <= size_.y())) {
    return floor;
  }
  const Cell& cell =
      cells_[cellAt(from_corner.y(), cell_size_, rows_) * columns_ + cellAt(from_corner.x(), cell_size_, columns_)];
  const double strength = strengthOf(cell, tick);
  return strength < kInvisible ? floor : between(floor, cell.color, strength);
}

PaintLayer::Spot PaintLayer::spot(std::size_t number, std::uint64_t tick) const {
  const Cell& cell = cells_[painted_[number]];
  const double strength = strengthOf(cell, tick);
  return {corner_ + cell_size_ * Eigen::Vector2d(columnOf(number) + 0.5, rowOf(number) + 0.5), cell.color,
          strength < kInvisible ? 0.0 : strength};
}

std::size_t PaintLayer::columnAt(double x) const {
  return cellAt(std::clamp(x - corner_.x(), 0.0, size_.x()), cell_size_, columns_);
}

std::size_t PaintLayer::rowAt(double y) const {
  return cellAt(std::clamp(y - corner_.y(), 0.0, size_.y()), cell_size_, rows_);
}

PaintLayer::Square PaintLayer::squareAround(const PaintDisc& disc) const {
  return {columnAt(disc.position.x() - disc.radius), columnAt(disc.position.x() + disc.radius),
          rowAt(disc.position.y() - disc.radius), rowAt(disc.position.y() + disc.radius)};
}

std::size_t PaintLayer::cellsAround(const PaintDisc& disc) const {
  SWARMANOID_EXPECTS(exists());
  const Square square = squareAround(disc);
  return (square.last_column - square.first_column + 1) * (square.last_row - square.first_row + 1);
}

void PaintLayer::paint(const PaintDisc& disc, std::uint64_t tick) {
  SWARMANOID_EXPECTS(exists());
  const Square square = squareAround(disc);
  const Eigen::Vector2d centre = disc.position - corner_;
  bool is_painted = false;
  for (std::size_t row = square.first_row; row <= square.last_row; ++row) {
    for (std::size_t column = square.first_column; column <= square.last_column; ++column) {
      const Eigen::Vector2d middle =
          cell_size_ * Eigen::Vector2d(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5);
      if ((middle - centre).squaredNorm() <= disc.radius * disc.radius) {
        paintCell(row * columns_ + column, disc, tick);
        is_painted = true;
      }
    }
  }
  if (!is_painted) {
    paintCell(rowAt(disc.position.y()) * columns_ + columnAt(disc.position.x()), disc, tick);
  }
}

void PaintLayer::archive(StateArchive& state) {
  if (state.isLoading()) {
    for (const std::uint32_t index : painted_) {
      cells_[index] = Cell{};
    }
  }
  state(painted_, digest_);
  for (const std::uint32_t index : painted_) {
    state(cells_.at(index));
  }
}

void PaintLayer::paintCell(std::size_t index, const PaintDisc& disc, std::uint64_t tick) {
  const auto digestOf = [index](const Cell& cell) {
    std::array<std::uint64_t, 3> words{index, cell.tick, 0};
    std::memcpy(&words[2], &cell.strength, sizeof(cell.strength));
    std::memcpy(reinterpret_cast<char*>(&words[2]) + sizeof(cell.strength), &cell.color, sizeof(cell.color));
    return XXH3_64bits(words.data(), sizeof(words));
  };
  Cell& cell = cells_[index];
  if (cell.strength == 0.0F) {
    painted_.push_back(static_cast<std::uint32_t>(index));
  } else {
    digest_ -= digestOf(cell);
  }
  const double old_part = strengthOf(cell, tick) * (1.0 - disc.strength);
  const double strength = disc.strength + old_part;
  cell = {tick, static_cast<float>(strength), between(cell.color, disc.color, disc.strength / strength)};
  digest_ += digestOf(cell);
}

}  // namespace swarmanoid
