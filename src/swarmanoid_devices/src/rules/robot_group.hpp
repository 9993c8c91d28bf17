/// The robots that a rule measures: those whose names begin alike.
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

/// Phase `rule`, one thread; `look` says who is there until it is called again.
class RobotGroup {
 public:
  RobotGroup() = default;
  explicit RobotGroup(std::string beginning) : beginning_(std::move(beginning)) {}

  static Parameter parameter() {
    return makeParameter("robots", Parameter::Type::kText, "", "", {},
                         "What the names of those that count begin with; empty: all robots.");
  }

  /// Once a tick. Allocates only while there are more entities than ever before; costs next to nothing while nobody
  /// comes or goes.
  /// @return whether others are there than at the last look: then the centroid jumps, which is no motion
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
  /// For a run that begins: nobody has been seen yet.
  void forget() {
    population_ = {};
    rows_.clear();
    numbers_.clear();
  }

  /// By entity number, as of the last look.
  const std::vector<Row>& rows() const { return rows_; }

  /// Where a robot stands in `rows`; kNoPlace for who does not count.
  using Place = std::int32_t;
  static constexpr Place kNoPlace = -1;
  /// @pre the row is of an entity that there was at the last look
  Place placeOf(Row row) const { return place_by_row_[row]; }

  /// The mean of their positions in W, seen from above [m]. @return nothing if there are none
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
  std::vector<EntityNumber> numbers_;  // which, unlike rows, are nobody else's later
};

}  // namespace swarmanoid::devices
