/// Queries of the positional index that take a visitor; see positional_index.hpp.
#pragma once

#include <algorithm>
#include <cmath>

#include "swarmanoid_interface/range.hpp"
#include "swarmanoid_space/index/positional_index.hpp"

namespace swarmanoid {

template <class Visit>
void PositionalIndex::visitPlaces(const Eigen::Vector3d& centre, const Eigen::Vector3d& reach, Visit visit) const {
  refresh();
  constexpr double kRounding = 1e-9;  // m: the cells must contain everything that Outline::meets accepts
  const Eigen::Vector3d half = (reach.array() + (largest_small_radius_ + kRounding)).matrix();
  const Cell low = cellOf(centre - half);
  const Cell high = cellOf(centre + half);
  for (int z = low[2]; z <= high[2]; ++z) {
    for (int y = low[1]; y <= high[1]; ++y) {
      // cells of one line are neighbours in memory
      const Place first = first_item_[flat({low[0], y, z})];
      const Place last = first_item_[flat({high[0], y, z}) + 1];
      for (Place place = first; place < last; ++place) {
        visit(place);
      }
    }
  }
}

template <class Visit>
void PositionalIndex::visitLarge(const Eigen::Vector3d& centre, double radius, Visit visit) const {
  refresh();
  large_grid_.visitNear(centre.head<2>(), radius, [&](std::int32_t place) {
    const LargeOutline& large = large_items_[static_cast<std::size_t>(place)];
    return !large.meets(centre, radius) || visit(large);
  });
}

template <class Visit>
void PositionalIndex::visitUpright(const Eigen::Vector2d& axis, double radius, Visit visit) const {
  refresh();
  large_grid_.visitNear(axis, radius, [&](std::int32_t place) {
    visit(large_items_[static_cast<std::size_t>(place)].row);
    return true;
  });
  const Eigen::Vector3d middle(axis.x(), axis.y(), corner_.z() + 0.5 * size_.z());
  visitPlaces(middle, {radius, radius, kInfinity}, [&](Place place) {
    const double reach = radius + items_[place].radius;
    if ((items_[place].position - axis).squaredNorm() <= reach * reach) {
      visit(items_[place].row);
    }
  });
}

template <class IsLargeMeant, class Visit>
void PositionalIndex::visitPairs(const Entities& entities, double distance, IsLargeMeant is_large_meant,
                                 Visit visit) const {
  refresh();
  const auto origin_of = [&](Row row) -> Eigen::Vector2d { return entities.pose[row].position.template head<2>(); };
  const double square = distance * distance;
  for (std::size_t i = 0; i < large_items_.size(); ++i) {
    const Row row = large_items_[i].row;
    if (!is_large_meant(row)) {
      continue;
    }
    const Eigen::Vector2d origin = origin_of(row);
    for (std::size_t k = i + 1; k < large_items_.size(); ++k) {
      const double found = (origin_of(large_items_[k].row) - origin).squaredNorm();
      if (found <= square && is_large_meant(large_items_[k].row)) {
        visit(row, large_items_[k].row, found);
      }
    }
    const Eigen::Vector3d middle(origin.x(), origin.y(), corner_.z() + 0.5 * size_.z());
    visitPlaces(middle, {distance, distance, kInfinity}, [&](Place place) {
      const double found = (items_[place].position - origin).squaredNorm();
      if (found <= square) {
        visit(row, items_[place].row, found);
      }
    });
  }
  const bool is_flat = cells_[2] == 1;  // heights need not be looked up then
  for (Place place = 0; place < items_.size(); ++place) {
    const Outline& one = items_[place];
    const double height = is_flat ? 0.0 : entities.pose[one.row].position.z();
    visitLaterNear(cellOf({one.position.x(), one.position.y(), height}), place, distance,
                   [&](Place other, double found) { visit(one.row, items_[other].row, found); });
  }
}

template <class Visit>
void PositionalIndex::visitLaterNear(const Cell& cell, Place place, double distance, Visit visit) const {
  constexpr double kRounding = 1e-9;  // m
  // entities outside the arena are in border cells, which are never farther apart than the entities
  const int reach = static_cast<int>(std::min(std::ceil((distance + kRounding) * inverse_cell_size_), 1e6));
  const int left = std::max(cell[0] - reach, 0);
  const int right = std::min(cell[0] + reach, cells_[0] - 1);
  const Eigen::Vector2d axis = items_[place].position;
  const double square = distance * distance;
  for (int z = cell[2]; z < cells_[2]; ++z) {
    const bool is_own_layer = z == cell[2];
    for (int y = is_own_layer ? cell[1] : std::max(cell[1] - reach, 0); y <= std::min(cell[1] + reach, cells_[1] - 1);
         ++y) {
      // cells of one line are neighbours in memory; in the own line, earlier places have already visited this pair
      const Place first = is_own_layer && y == cell[1] ? place + 1 : first_item_[flat({left, y, z})];
      const Place last = first_item_[flat({right, y, z}) + 1];
      for (Place other = first; other < last; ++other) {
        const double found = (items_[other].position - axis).squaredNorm();
        if (found <= square) {
          visit(other, found);
        }
      }
    }
  }
}

}  // namespace swarmanoid
