#include "swarmanoid_space/index/positional_index.hpp"

#include <algorithm>
#include <cmath>

#include "bounds_of.hpp"
#include "swarmanoid_interface/expects.hpp"
#include "swarmanoid_interface/range.hpp"
#include "swarmanoid_space/index/cell_layout.hpp"
#include "swarmanoid_space/index/positional_index_visits.hpp"

namespace swarmanoid {
namespace {

constexpr double kSmallestCell = 0.25;  // m: about the size of a robot with its sensing range
constexpr int kMostCellsPerAxis = 1024;
constexpr double kMostCells = 1U << 20U;

/// As Outline::meets, but without branches: all comparisons are always evaluated.
bool meetsSphere(const PositionalIndex::Outline& outline, const Eigen::Vector3d& centre, double radius) {
  const double reach = radius + outline.radius;
  const auto is_beside = static_cast<int>((outline.position - centre.head<2>()).squaredNorm() <= reach * reach);
  const auto is_above = static_cast<int>(outline.high >= centre.z() - radius);
  const auto is_below = static_cast<int>(outline.low <= centre.z() + radius);
  return (is_beside & is_above & is_below) != 0;
}

}  // namespace

void PositionalIndex::configure(const Eigen::Vector3d& size, Optimization optimization, std::size_t expected_entities,
                                const Eigen::Vector3d& corner) {
  corner_ = corner;
  size_ = size;
  optimization_ = optimization;
  // about one entity per cell: fewer make large ranges slow, more make small ones slow
  const double volume = optimization == Optimization::k2D ? size.x() * size.y() : size.x() * size.y() * size.z();
  const double per_entity = volume / static_cast<double>(std::max<std::size_t>(expected_entities, 1));
  cell_size_ =
      std::max(kSmallestCell, optimization == Optimization::k2D ? std::sqrt(per_entity) : std::cbrt(per_entity));
  cell_size_ = std::max(cell_size_, size.maxCoeff() / kMostCellsPerAxis);
  cell_size_ = std::max(cell_size_, std::cbrt(volume / kMostCells));
  for (int axis = 0; axis < 3; ++axis) {
    const bool flat_axis = axis == 2 && optimization == Optimization::k2D;
    cells_[static_cast<std::size_t>(axis)] = flat_axis ? 1 : static_cast<int>(std::ceil(size[axis] / cell_size_));
  }
  inverse_cell_size_ = 1.0 / cell_size_;
  first_item_.assign(static_cast<std::size_t>(cells_[0]) * cells_[1] * cells_[2] + 1, 0);
  large_grid_.configure(corner.head<2>(), size.head<2>());
  state_ = State::kRebuilt;
}

PositionalIndex::Cell PositionalIndex::cellOf(const Eigen::Vector3d& position) const {
  const Eigen::Vector3d cell = (position - corner_) * inverse_cell_size_;
  return {clampedCell(cell.x(), cells_[0]), clampedCell(cell.y(), cells_[1]), clampedCell(cell.z(), cells_[2])};
}

std::size_t PositionalIndex::flat(const Cell& cell) const {
  return (static_cast<std::size_t>(cell[2]) * cells_[1] + cell[1]) * cells_[0] + cell[0];
}

void PositionalIndex::rebuild(const Entities& entities) {
  sortIn(entities);
  state_ = State::kRebuilt;
}

void PositionalIndex::close() {
  was_asked_ = state_ == State::kAsked;
  state_ = State::kClosed;
}

void PositionalIndex::update(const Entities& entities) {
  if (state_ == State::kAsked || (state_ == State::kClosed && was_asked_)) {
    rebuild(entities);
  } else {
    forget(entities);
  }
}

void PositionalIndex::forget(const Entities& entities) {
  entities_ = &entities;
  state_ = State::kOld;
}

void PositionalIndex::refreshOnce() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  SWARMANOID_EXPECTS(state_ != State::kClosed);
  if (state_ == State::kOld) {
    sortIn(*entities_);
  }
  state_ = State::kAsked;
}

void PositionalIndex::sortIn(const Entities& entities) const {
  // counting sort by cell: count, prefix sums, placement
  constexpr std::uint32_t kLarge = ~0U;
  large_items_.clear();
  largest_small_radius_ = 0.0;
  std::fill(first_item_.begin(), first_item_.end(), 0U);
  cell_of_entity_.resize(entities.order.size());
  for (std::size_t k = 0; k < entities.order.size(); ++k) {
    const Row row = entities.order[k];
    const double radius = entities.model[row]->moving_reach;
    if (isLarge(*entities.model[row])) {
      cell_of_entity_[k] = kLarge;
      large_items_.push_back({boundsOf(*entities.model[row], entities.pose[row]), row});
      continue;
    }
    largest_small_radius_ = std::max(largest_small_radius_, radius);
    cell_of_entity_[k] = static_cast<std::uint32_t>(flat(cellOf(entities.pose[row].position)));
    ++first_item_[cell_of_entity_[k]];
  }
  sortLargeIn();
  std::uint32_t sum = 0;
  for (std::uint32_t& first : first_item_) {
    sum += first;
    first = sum;
  }
  items_.resize(sum);
  for (std::size_t k = entities.order.size(); k-- > 0;) {
    if (cell_of_entity_[k] != kLarge) {
      items_[--first_item_[cell_of_entity_[k]]] = outlineOf(entities, entities.order[k]);
    }
  }
}

/// Sorts the large entities into the grid. Most of them, such as walls, have not moved.
void PositionalIndex::sortLargeIn() const {
  std::int32_t place = 0;
  for (; place < static_cast<std::int32_t>(large_items_.size()); ++place) {
    const Eigen::AlignedBox3d& bounds = large_items_[static_cast<std::size_t>(place)].bounds;
    const Eigen::AlignedBox2d above(bounds.min().head<2>(), bounds.max().head<2>());
    const bool is_there = large_grid_.has(place) && large_grid_.bounds(place).min() == above.min() &&
                          large_grid_.bounds(place).max() == above.max();
    if (!is_there) {
      large_grid_.set(place, above);
    }
  }
  for (; large_grid_.has(place); ++place) {
    large_grid_.remove(place);
  }
}

PositionalIndex::Outline PositionalIndex::outlineOf(const Entities& entities, Row row) {
  const EntityModel& model = *entities.model[row];
  const Eigen::Vector3d& p = entities.pose[row].position;
  if (entities.pose[row].isUpright() && model.joints_keep_outline && !model.shapes.empty()) {
    return {p.head<2>(), model.horizontal_radius, p.z() + model.lowest, p.z() + model.highest, row, true};
  }
  return {p.head<2>(), model.moving_reach, p.z() - model.moving_reach, p.z() + model.moving_reach, row, false};
}

template <class Visit>
void PositionalIndex::visitNear(const Eigen::Vector3d& centre, double radius, Visit visit) const {
  visitLarge(centre, radius, [&](const LargeOutline& large) {
    visit(large.row);
    return true;
  });
  visitPlaces(centre, Eigen::Vector3d::Constant(radius), [&](Place place) {
    if (items_[place].meets(centre, radius)) {
      visit(items_[place].row);
    }
  });
}

void PositionalIndex::collect(const Eigen::Vector3d& centre, double radius, std::vector<Row>& found) const {
  visitNear(centre, radius, [&](Row row) { found.push_back(row); });
}

void PositionalIndex::collectUpright(const Eigen::Vector2d& axis, double radius, std::vector<Row>& found) const {
  visitUpright(axis, radius, [&](Row row) { found.push_back(row); });
}

void PositionalIndex::collectPlaces(const Eigen::Vector3d& centre, double radius, std::vector<Place>& found) const {
  constexpr std::size_t kMore = 64;  // so that the buffer rarely grows
  std::size_t count = found.size();
  visitPlaces(centre, Eigen::Vector3d::Constant(radius), [&](Place place) {
    // every place is written; the next one overwrites it unless the outline meets the sphere. Near the border of the
    // sphere a branch would often be mispredicted
    if (count == found.size()) {
      found.resize(count + kMore);
    }
    found[count] = place;
    count += meetsSphere(items_[place], centre, radius) ? 1 : 0;
  });
  found.resize(count);
}

std::vector<Row> PositionalIndex::within(const Entities& entities, const Eigen::Vector3d& centre, double radius) const {
  // an origin may be outside its entity's bounds, by at most the largest bounding radius
  refresh();
  std::vector<Row> found;
  for (const LargeOutline& large : large_items_) {
    found.push_back(large.row);
  }
  const double largest = largest_small_radius_;
  visitNear(centre, radius + largest, [&](Row row) { found.push_back(row); });
  const auto number = [&](Row row) { return entities.number[row]; };
  std::sort(found.begin(), found.end(), [&](Row a, Row b) { return number(a) < number(b); });
  found.erase(std::unique(found.begin(), found.end()), found.end());
  const auto is_far = [&](Row row) {
    const Eigen::Vector3d& origin = entities.pose[row].position;
    return (origin - centre).squaredNorm() > radius * radius;
  };
  found.erase(std::remove_if(found.begin(), found.end(), is_far), found.end());
  return found;
}

std::vector<Row> PositionalIndex::within(const Entities& entities, Row around, double radius) const {
  std::vector<Row> found = within(entities, entities.pose[around].position, radius);
  found.erase(std::remove(found.begin(), found.end(), around), found.end());
  return found;
}

}  // namespace swarmanoid
