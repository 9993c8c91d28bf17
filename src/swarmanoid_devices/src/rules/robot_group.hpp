/// The robots that a rule measures: those whose names begin alike.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

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

  /// Once a tick. Allocates only while there are more entities than ever before.
  /// @return whether others are there than at the last look: then the centroid jumps, which is no motion
  bool look(const Space& space) {
    const Entities& entities = space.entities;
    rows_.reserve(entities.size());
    numbers_.reserve(entities.size());
    rows_.clear();
    for (const Row row : entities.order) {
      if (entities.model[row]->is_robot && entities.name[row].compare(0, beginning_.size(), beginning_) == 0) {
        rows_.push_back(row);
      }
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
    rows_.clear();
    numbers_.clear();
  }

  /// By entity number, as of the last look.
  const std::vector<Row>& rows() const { return rows_; }

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
  std::vector<Row> rows_;
  std::vector<EntityNumber> numbers_;  // which, unlike rows, are nobody else's later
};

}  // namespace swarmanoid::devices
