/// Positions along the Hilbert curve (Hilbert 1891), which visits each cell of a square once. Points that are close
/// along the curve are close in the square, and mostly the reverse.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

namespace swarmanoid {

/// Position along the curve of a point of the unit square, in cells of 2^-16.
/// @pre x and y are from 0 to 1
inline std::uint64_t placeOnCurve(double x, double y) {
  constexpr std::uint32_t kCells = 1U << 16U;
  std::uint32_t column = std::min(kCells - 1, static_cast<std::uint32_t>(x * kCells));
  std::uint32_t line = std::min(kCells - 1, static_cast<std::uint32_t>(y * kCells));
  std::uint64_t place = 0;
  for (std::uint32_t side = kCells / 2; side > 0; side /= 2) {
    const bool is_right = (column & side) != 0;
    const bool is_upper = (line & side) != 0;
    // the curve visits four squares: lower left, upper left, upper right, lower right
    const std::uint64_t square = is_right ? (is_upper ? 2 : 3) : (is_upper ? 1 : 0);
    place += square * side * side;
    if (!is_upper) {  // the curve is turned in the lower squares
      if (is_right) {
        column = kCells - 1 - column;
        line = kCells - 1 - line;
      }
      std::swap(column, line);
    }
  }
  return place;
}

}  // namespace swarmanoid
