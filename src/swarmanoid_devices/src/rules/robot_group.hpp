/// The robots that a rule measures, selected by a prefix of their names.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "population.hpp"
#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

/// Phase `rule`, one thread. The group is that of the last call of `look`.
class RobotGroup {
 public:
  RobotGroup() = default;
  explicit RobotGroup(std::string beginning) : beginning_(std::move(beginning)) {}

  static Parameter parameter() {
    return makeParameter("robots", Parameter::Type::kText, "", "", {},
                         "Name prefix of the robots that count; empty: all robots.");
  }

  /// Updates the group; called once a tick. Allocates only when the number of entities reaches a new maximum, and is
  /// cheap while no entity is added or deleted.
  /// @return whether the group differs from that of the last call: its centroid then jumps without motion
  bool look(const Space& space) {
    const Entities& entities = space.entities;
    if (!population_.hasChanged(space)) {
      return false;
    }
    rows_.reserve(entities.size());
    numbers_.reserve(entities.size());
    rows_.clear();
    for (const Row row : entities.order) {
      if (entities.model[row]->is_robot && entities.name[row].compare(0, beginning_.size(), beginning_) == 0) {
        rows_.push_back(row);
      }
    }
    place_by_row_.resize(entities.rowCount());
    std::fill(place_by_row_.begin(), place_by_row_.end(), kNoPlace);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      place_by_row_[rows_[i]] = static_cast<Place>(i);
    }
    bool is_changed = rows_.size() != numbers_.size();
    numbers_.resize(rows_.size(), kNoEntity);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      is_changed = is_changed || numbers_[i] != entities.number[rows_[i]];
      numbers_[i] = entities.number[rows_[i]];
    }
    return is_changed;
  }
  /// Resets the group for a new run.
  void forget() {
    population_ = {};
    rows_.clear();
    numbers_.clear();
  }

  /// For snapshots: the next call of `look` finds the rows again, and notices the same changes.
  void archive(StateArchive& state) {
    state(numbers_);
    if (state.isLoading()) {
      population_ = {};
    }
  }

  /// Rows of the robots by entity number, as of the last call of `look`.
  const std::vector<Row>& rows() const { return rows_; }

  /// Index of a robot in `rows`; kNoPlace for entities outside the group.
  using Place = std::int32_t;
  static constexpr Place kNoPlace = -1;
  /// @pre the entity existed in the last call of `look`
  Place placeOf(Row row) const { return place_by_row_[row]; }

  /// Mean of the robots' horizontal positions in W [m]. @return nothing without robots
  std::optional<Eigen::Vector2d> centroid(const Space& space) const {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const Row row : rows_) {
      sum += space.entities.pose[row].position.head<2>();
    }
    return rows_.empty() ? std::nullopt : std::optional<Eigen::Vector2d>(sum / static_cast<double>(rows_.size()));
  }

 private:
  std::string beginning_;
  Population population_;
  std::vector<Row> rows_;
  RowMap<Place> place_by_row_;
  std::vector<EntityNumber> numbers_;  // unlike rows, never reused
};

}  // namespace swarmanoid::devices
