// The Hilbert curve visits each cell of a square once, and moves from each to a neighbour.
#include "../src/world/curve_place.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <utility>

namespace swarmanoid::test {
namespace {

TEST(CurvePlaceTest, GoesOnceThroughEachCellFromNeighbourToNeighbour) {
  constexpr int kSide = 32;
  std::map<std::uint64_t, std::pair<int, int>> cells;  // by position along the curve
  for (int line = 0; line < kSide; ++line) {
    for (int column = 0; column < kSide; ++column) {
      cells[placeOnCurve((column + 0.37) / kSide, (line + 0.81) / kSide)] = {column, line};
    }
  }
  ASSERT_EQ(cells.size(), static_cast<std::size_t>(kSide) * kSide);
  const std::pair<int, int>* last = nullptr;
  for (const auto& [place, cell] : cells) {
    if (last != nullptr) {
      EXPECT_EQ(std::abs(cell.first - last->first) + std::abs(cell.second - last->second), 1) << place;
    }
    last = &cell;
  }
}

TEST(CurvePlaceTest, BeginsAndEndsInTheLowerCorners) {
  EXPECT_EQ(placeOnCurve(0.0, 0.0), 0U);
  EXPECT_EQ(placeOnCurve(0.9999999, 0.0), (std::uint64_t{1} << 32U) - 1);
}

}  // namespace
}  // namespace swarmanoid::test
